/* operations.c - solids: operations within operations, and members, as steps in postfix order. */
#include "parse_state.h"

#include "scene/solid.h"

/* Returns the open solid, which is the last one; NULL before the last pass. */
static struct tia_solid *open_solid(struct tia_parse *job)
{
    struct tia_array *solids = &job->arrays[TIA_OF_SOLIDS];
    struct tia_solid *first = (struct tia_solid *)(void *)solids->items;

    return first && job->pass == TIA_FILLING && solids->count <= solids->capacity ? &first[solids->count - 1] : NULL;
}

static void add_step(struct tia_parse *job, uint8_t step)
{
    struct tia_solid *solid = open_solid(job);

    (void)tia_parse_add(job, TIA_OF_STEPS, &step);
    if (solid)
        solid->step_count++;
}

/* Counts an operand of the innermost operation; each but its first is followed by the operation. */
static void count_operand(struct tia_parse *job)
{
    unsigned i = job->group_count - 1;

    while (!job->groups[i].operation)
        i--;
    if (job->groups[i].operands++)
        add_step(job, job->groups[i].operation);
}

int tia_operation_add(struct tia_parse *job, const struct tia_shape *member)
{
    struct tia_solid *solid = open_solid(job);

    if (!tia_solid_member_kind(member))
        return tia_text_error(&job->text, &job->first, "cannot be a member of a solid",
                              "a sphere, plane, box or torus, or a cylinder or cone that is capped");
    if (solid && solid->member_count == TIA_SOLID_MEMBERS)
        return tia_text_error(&job->text, &job->first, "is a member too many", "at most 32 in a solid");
    (void)tia_parse_add(job, TIA_OF_MEMBERS, member);
    if (solid)
        solid->member_count++;
    add_step(job, TIA_SOLID_MEMBER);
    count_operand(job);
    return TIA_OK;
}

int tia_operation_end(struct tia_parse *job)
{
    bool empty = !job->groups[job->group_count - 1].operands;

    if (empty)
        (void)tia_text_error(&job->text, &job->first, "ends a solid without members", "a shape before it");
    if (empty && !tia_text_goes_on(&job->text))
        return TIA_ERR_RANGE;
    if (job->solid_groups == job->group_count)
        job->solid_groups = 0;
    job->group_count--;
    if (job->solid_groups)
        count_operand(job);
    return TIA_OK;
}
