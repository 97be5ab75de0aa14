/* meshes.c - faces, and the shapes that place them. */
#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "textures.h"

/* Meshes with fewer faces are not worth a transform. */
#define INSTANCE_FACES 8
/* Half the extent of an instanced mesh in its own unit is 2^3 to 2^4, so that scales have many bits, too. */
#define INSTANCE_BITS 3
#define INSTANCE_SCALE_MIN 0x1p-6

static struct pack_array *array_of(struct convert *c, enum model_array_name name)
{
    return &c->pack.arrays[name];
}

static void vertex_of(const struct aiMesh *mesh, unsigned index, double to[3])
{
    const struct aiVector3D *v = &mesh->mVertices[index];
    to[0] = (double)v->x, to[1] = (double)v->y, to[2] = (double)v->z;
}

/* True for a triangle whose corners exist. */
static bool is_triangle(const struct aiMesh *mesh, const struct aiFace *face)
{
    return face->mNumIndices == 3 && face->mIndices[0] < mesh->mNumVertices && face->mIndices[1] < mesh->mNumVertices &&
           face->mIndices[2] < mesh->mNumVertices;
}

/* Returns the corners of a face where they are placed. False if it has no place. */
static bool corners_of(const struct aiMesh *mesh, const struct aiFace *face, const struct affine *place,
                       double corners[3][3])
{
    if (!is_triangle(mesh, face))
        return false;
    for (int i = 0; i < 3; i++) {
        double own[3];
        vertex_of(mesh, face->mIndices[i], own);
        affine_point(place, own, corners[i]);
        if (!vector_is_finite(corners[i]) || vector_length(corners[i]) > FLT_MAX)
            return false;
    }
    return true;
}

/* ---- measuring ---- */

static uint64_t measure_use(struct convert *c, const struct mesh_use *use)
{
    const struct aiMesh *mesh = c->from->mMeshes[use->mesh];
    double corners[3][3];
    uint64_t bad = 0;

    for (unsigned i = 0; i < mesh->mNumFaces; i++)
        if (!corners_of(mesh, &mesh->mFaces[i], &use->to_world, corners))
            bad++;
        else
            for (int k = 0; k < 3; k++)
                box_extend(&c->box, corners[k]);
    return bad;
}

static void choose_instance(struct convert *c, struct mesh_use *use)
{
    double scale[3], degrees[3];

    use->instance = c->mesh_uses[use->mesh] > 1 && c->from->mMeshes[use->mesh]->mNumFaces >= INSTANCE_FACES &&
                    affine_split(&use->to_world, scale, degrees);
}

int convert_measure(struct convert *c)
{
    uint64_t faces = 0, bad = 0;

    c->box = box_empty();
    for (uint32_t i = 0; i < c->use_count; i++) {
        faces += c->from->mMeshes[c->uses[i].mesh]->mNumFaces;
        bad += measure_use(c, &c->uses[i]);
        choose_instance(c, &c->uses[i]);
    }
    if (faces == 0 || box_is_empty(&c->box))
        return convert_fail(c, TIA_ERR_RANGE, "the model has no faces");
    if (bad > 0)
        convert_warn(c, TIA_WARN_FACE, "%llu faces have corners without a place: left out", (unsigned long long)bad);
    return TIA_OK;
}

/* ---- vertices ---- */

/* A part of the scene's mesh that is being filled. */
struct mesh_part {
    const struct aiMesh *mesh;
    struct affine place; /* into the packed unit */
    bool mirrored;
    unsigned uv_channel;
    bool has_uvs;
    uint32_t vertex_base, normal_base, uv_base; /* in the mesh of the scene */
};

static bool add_vertices(struct convert *c, const struct mesh_part *part)
{
    struct tia_vec3 *to = pack_grow(array_of(c, MODEL_VERTICES), part->mesh->mNumVertices);

    for (unsigned i = 0; to && i < part->mesh->mNumVertices; i++) {
        double own[3], at[3];
        vertex_of(part->mesh, i, own);
        affine_point(&part->place, own, at);
        to[i] = (struct tia_vec3){convert_fixed(at[0], TIA_Q16_ONE), convert_fixed(at[1], TIA_Q16_ONE),
                                  convert_fixed(at[2], TIA_Q16_ONE)};
    }
    return to;
}

/* Adds the normals. One without a direction becomes +y: faces with it are left without normals, see normal_is_usable.
 */
static bool add_normals(struct convert *c, const struct mesh_part *part)
{
    struct tia_dir3 *to = part->mesh->mNormals ? pack_grow(array_of(c, MODEL_NORMALS), part->mesh->mNumVertices) : NULL;

    for (unsigned i = 0; to && i < part->mesh->mNumVertices; i++) {
        const struct aiVector3D *n = &part->mesh->mNormals[i];
        double own[3] = {(double)n->x, (double)n->y, (double)n->z}, at[3];
        affine_normal(&part->place, own, at);
        for (int k = 0; k < 3 && part->mirrored; k++)
            at[k] = -at[k];
        to[i] = vector_normalise(at) ? convert_direction(at) : (struct tia_dir3){0, TIA_Q30_ONE, 0};
    }
    return to || !part->mesh->mNormals;
}

static bool add_uvs(struct convert *c, const struct mesh_part *part)
{
    struct tia_uv *to = part->has_uvs ? pack_grow(array_of(c, MODEL_UVS), part->mesh->mNumVertices) : NULL;

    for (unsigned i = 0; to && i < part->mesh->mNumVertices; i++) {
        const struct aiVector3D *uv = &part->mesh->mTextureCoords[part->uv_channel][i];
        to[i] = (struct tia_uv){convert_fixed((double)uv->x, TIA_Q16_ONE), convert_fixed((double)uv->y, TIA_Q16_ONE)};
    }
    return to || !part->has_uvs;
}

static bool normal_is_usable(const struct aiVector3D *n)
{
    double v[3] = {(double)n->x, (double)n->y, (double)n->z};
    return vector_is_finite(v) && vector_length(v) > 1e-12 && vector_length(v) < 1e12;
}

static bool has_normals(const struct aiMesh *mesh, const struct aiFace *face)
{
    return mesh->mNormals && normal_is_usable(&mesh->mNormals[face->mIndices[0]]) &&
           normal_is_usable(&mesh->mNormals[face->mIndices[1]]) && normal_is_usable(&mesh->mNormals[face->mIndices[2]]);
}

/* Adds the faces. A mirrored one is turned, so that its front stays in front. */
static bool add_faces(struct convert *c, const struct mesh_part *part, uint64_t *added)
{
    double corners[3][3];

    *added = 0;
    for (unsigned i = 0; i < part->mesh->mNumFaces; i++) {
        const struct aiFace *from = &part->mesh->mFaces[i];
        struct tia_face face;
        if (!corners_of(part->mesh, from, &part->place, corners))
            continue;
        bool normals = has_normals(part->mesh, from);
        for (int k = 0; k < 3; k++) {
            uint32_t index = from->mIndices[part->mirrored ? 2 - k : k];
            face.corner[k] =
                (struct tia_corner){part->vertex_base + index, normals ? part->normal_base + index : TIA_NO_INDEX,
                                    part->has_uvs ? part->uv_base + index : TIA_NO_INDEX};
        }
        if (!pack_add(array_of(c, MODEL_FACES), &face))
            return false;
        ++*added;
    }
    return true;
}

/* ---- meshes ---- */

static void begin_range(struct convert *c, struct model_range *range, enum model_array_name name)
{
    *range = (struct model_range){.first = array_of(c, name)->count};
}

static struct model_mesh begin_mesh(struct convert *c)
{
    struct model_mesh mesh;

    begin_range(c, &mesh.vertices, MODEL_VERTICES);
    begin_range(c, &mesh.normals, MODEL_NORMALS);
    begin_range(c, &mesh.uvs, MODEL_UVS);
    begin_range(c, &mesh.faces, MODEL_FACES);
    begin_range(c, &mesh.groups, MODEL_GROUPS);
    return mesh;
}

static void end_range(struct convert *c, struct model_range *range, enum model_array_name name)
{
    range->count = array_of(c, name)->count - range->first;
}

/* Adds a mesh with the elements since begin_mesh. */
static bool end_mesh(struct convert *c, struct model_mesh *mesh)
{
    end_range(c, &mesh->vertices, MODEL_VERTICES);
    end_range(c, &mesh->normals, MODEL_NORMALS);
    end_range(c, &mesh->uvs, MODEL_UVS);
    end_range(c, &mesh->faces, MODEL_FACES);
    end_range(c, &mesh->groups, MODEL_GROUPS);
    return pack_add(array_of(c, MODEL_MESHES), mesh);
}

static bool add_shape(struct convert *c, uint64_t mesh, uint32_t material, uint32_t transform)
{
    struct tia_shape shape = {.kind = TIA_MESH, .material = material, .transform = transform, .mesh = (uint32_t)mesh};
    return pack_add(array_of(c, MODEL_SHAPES), &shape);
}

/* Adds a part to `mesh`. */
static bool add_part(struct convert *c, const struct model_mesh *mesh, struct mesh_part part, uint32_t group)
{
    uint64_t faces;

    unsigned material = part.mesh->mMaterialIndex;
    part.uv_channel = material < c->from->mNumMaterials ? texture_channel(c->from->mMaterials[material]) : 0;
    part.uv_channel = part.mesh->mTextureCoords[part.uv_channel] ? part.uv_channel : 0;
    part.has_uvs = part.mesh->mTextureCoords[part.uv_channel];
    part.vertex_base = (uint32_t)(array_of(c, MODEL_VERTICES)->count - mesh->vertices.first);
    part.normal_base = (uint32_t)(array_of(c, MODEL_NORMALS)->count - mesh->normals.first);
    part.uv_base = (uint32_t)(array_of(c, MODEL_UVS)->count - mesh->uvs.first);
    if (!add_vertices(c, &part) || !add_normals(c, &part) || !add_uvs(c, &part) || !add_faces(c, &part, &faces))
        return false;
    uint32_t *groups = pack_grow(array_of(c, MODEL_GROUPS), faces);
    for (uint64_t i = 0; groups && i < faces; i++)
        groups[i] = group;
    return groups;
}

/* Returns the map from a use's vertices to the scene's unit. */
static struct affine placed(const struct convert *c, const struct mesh_use *use)
{
    struct affine place = use->to_world;

    for (int i = 0; i < 3; i++) {
        place.m[i][3] -= c->origin[i];
        for (int k = 0; k < 4; k++)
            place.m[i][k] = ldexp(place.m[i][k], c->bits);
    }
    return place;
}

/* Adds the mesh of the uses first..end-1, which have one material and are no instances. */
static bool add_placed(struct convert *c, uint32_t first, uint32_t end)
{
    struct model_mesh mesh = begin_mesh(c);
    uint32_t material = c->uses[first].material;

    for (uint32_t i = first; i < end; i++) {
        const struct mesh_use *use = &c->uses[i];
        struct mesh_part part = {.mesh = c->from->mMeshes[use->mesh],
                                 .place = placed(c, use),
                                 .mirrored = affine_determinant(&use->to_world) < 0};
        if (!use->instance && !add_part(c, &mesh, part, i - first))
            return false;
    }
    if (array_of(c, MODEL_FACES)->count == mesh.faces.first)
        return true;
    return end_mesh(c, &mesh) && add_shape(c, array_of(c, MODEL_MESHES)->count - 1, material, 0);
}

/* ---- instances ---- */

/* The mesh of instances, in its own unit: the vertex v of the file is (v - middle) 2^bits. */
struct instanced {
    uint64_t mesh;
    double middle[3];
    int bits;
    bool made, unsuited;
};

static struct box own_box(const struct aiMesh *mesh)
{
    const struct affine one = affine_one();
    struct box box = box_empty();
    double corners[3][3];

    for (unsigned i = 0; i < mesh->mNumFaces; i++)
        for (int k = 0; corners_of(mesh, &mesh->mFaces[i], &one, corners) && k < 3; k++)
            box_extend(&box, corners[k]);
    return box;
}

/* Makes the mesh. Returns false if there is no memory. */
static bool make_instanced(struct convert *c, struct instanced *made, uint32_t index)
{
    const struct aiMesh *from = c->from->mMeshes[index];
    struct box box = own_box(from);
    struct mesh_part part = {.mesh = from, .place = affine_one()};
    double half = 0;

    made->made = true;
    made->unsuited = box_is_empty(&box);
    if (made->unsuited)
        return true;
    for (int i = 0; i < 3; i++) {
        made->middle[i] = box.min[i] / 2 + box.max[i] / 2;
        half = fmax(half, box.max[i] / 2 - box.min[i] / 2);
    }
    made->unsuited = !(half > 0);
    if (made->unsuited)
        return true;
    made->bits = INSTANCE_BITS - ilogb(half);
    for (int i = 0; i < 3; i++) {
        part.place.m[i][i] = ldexp(1, made->bits);
        part.place.m[i][3] = -ldexp(made->middle[i], made->bits);
    }
    struct model_mesh mesh = begin_mesh(c);
    made->mesh = array_of(c, MODEL_MESHES)->count;
    return add_part(c, &mesh, part, 0) && end_mesh(c, &mesh);
}

/* Finds the transform of an instance. Returns false if it is out of range: too small, too large or too flat. */
static bool instance_transform(const struct convert *c, const struct mesh_use *use, const struct instanced *mesh,
                               struct tia_transform *transform)
{
    double scale[3], degrees[3], position[3], least = HUGE_VAL, most = 0;

    if (!affine_split(&use->to_world, scale, degrees))
        return false;
    affine_point(&use->to_world, mesh->middle, position);
    for (int i = 0; i < 3; i++) {
        scale[i] = ldexp(scale[i], c->bits - mesh->bits);
        least = fmin(least, scale[i]);
        most = fmax(most, scale[i]);
    }
    /* half the diagonal of the instance's box is below 2^4 sqrt 3 sqrt 3 `most`, and must be below 2^15 `least` */
    if (least < INSTANCE_SCALE_MIN || most > 1024 || most > 512 * least)
        return false;
    *transform = (struct tia_transform){
        .position = convert_place(c, position),
        .rotation = {convert_fixed(degrees[0], TIA_Q16_ONE), convert_fixed(degrees[1], TIA_Q16_ONE),
                     convert_fixed(degrees[2], TIA_Q16_ONE)},
        .scale = {convert_fixed(scale[0], TIA_Q16_ONE), convert_fixed(scale[1], TIA_Q16_ONE),
                  convert_fixed(scale[2], TIA_Q16_ONE)}};
    return true;
}

/* Adds an instance. If it cannot be one, use->instance becomes false. */
static bool add_instance(struct convert *c, struct mesh_use *use, struct instanced *mesh)
{
    struct tia_transform transform;

    if (!mesh->made && !make_instanced(c, mesh, use->mesh))
        return false;
    use->instance = !mesh->unsuited && instance_transform(c, use, mesh, &transform);
    if (!use->instance)
        return true;
    return pack_add(array_of(c, MODEL_TRANSFORMS), &transform) &&
           add_shape(c, mesh->mesh, use->material, (uint32_t)array_of(c, MODEL_TRANSFORMS)->count);
}

static bool add_instances(struct convert *c)
{
    struct instanced *meshes = calloc(c->from->mNumMeshes + (size_t)1, sizeof *meshes);
    bool fits = meshes;

    for (uint32_t i = 0; fits && i < c->use_count; i++)
        if (c->uses[i].instance)
            fits = add_instance(c, &c->uses[i], &meshes[c->uses[i].mesh]);
    free(meshes);
    return fits;
}

int convert_meshes(struct convert *c)
{
    bool fits = add_instances(c);

    for (uint32_t first = 0, end; fits && first < c->use_count; first = end) {
        for (end = first + 1; end < c->use_count && c->uses[end].material == c->uses[first].material;)
            end++;
        fits = add_placed(c, first, end);
    }
    if (!fits)
        return convert_exhausted(c);
    if (array_of(c, MODEL_FACES)->count > TIA_OBJECTS_MAX)
        return convert_fail(c, TIA_ERR_RANGE, "the model has too many faces, expected at most %u", TIA_OBJECTS_MAX);
    return TIA_OK;
}
