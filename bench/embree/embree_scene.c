#include "embree_scene.h"

bool embree_scene_begin(struct embree_scene *scene)
{
    scene->device = rtcNewDevice("threads=1");
    scene->scene = scene->device ? rtcNewScene(scene->device) : NULL;
    if (scene->scene)
        rtcSetSceneBuildQuality(scene->scene, RTC_BUILD_QUALITY_HIGH);
    return scene->scene;
}

void embree_scene_end(struct embree_scene *scene)
{
    if (scene->scene)
        rtcReleaseScene(scene->scene);
    if (scene->device)
        rtcReleaseDevice(scene->device);
}

struct vec (*embree_triangles(RTCGeometry geometry, uint32_t count))[3]
{
    uint32_t *index = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, count);

    for (uint32_t i = 0; i < 3 * count; i++)
        index[i] = i;
    return rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, 3 * (size_t)count);
}

float (*embree_rounds(RTCGeometry geometry, uint32_t count))[4]
{
    return rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 16, count);
}

void embree_attach(struct embree_scene *scene, RTCGeometry geometry, unsigned number)
{
    rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene->scene, geometry, number);
    rtcReleaseGeometry(geometry);
}
