/* number.c - the numbers of a .ply file, in text or binary. */
#include "ply.h"
#include "read/model/binary.h"

static unsigned size_of(uint8_t type)
{
    static const uint8_t sizes[] = {[PLY_I8] = 1,  [PLY_U8] = 1,  [PLY_I16] = 2, [PLY_U16] = 2,
                                    [PLY_I32] = 4, [PLY_U32] = 4, [PLY_F32] = 4, [PLY_F64] = 8};
    return sizes[type];
}

/* Converts an integer that fills `size` bytes. */
static enum tia_decimal from_integer(int64_t *out, uint64_t value, unsigned size, bool negative, unsigned bits)
{
    int64_t wide = (int64_t)value - (negative ? INT64_C(1) << (8 * size) : 0);

    if (wide >= INT64_C(1) << 31 || wide <= -(INT64_C(1) << 31))
        return TIA_DECIMAL_RANGE;
    *out = wide * (INT64_C(1) << bits);
    return TIA_DECIMAL_FINE;
}

static enum tia_decimal convert(int64_t *out, uint64_t value, uint8_t type, unsigned bits)
{
    unsigned size = size_of(type);
    bool is_signed = type == PLY_I8 || type == PLY_I16 || type == PLY_I32;

    if (type == PLY_F32)
        return tia_binary_float(out, (uint32_t)value, bits);
    if (type == PLY_F64)
        return tia_binary_double(out, value, bits);
    return from_integer(out, value, size, is_signed && value >> (8 * size - 1), bits);
}

int tia_ply_error(struct ply *ply, const char *why)
{
    (void)tia_plain_error(ply->p, ply->thing, ply->number);
    tia_say(&ply->p->model.reader->error, why);
    return TIA_ERR_RANGE;
}

/* Takes the bytes of a number. */
static int take(struct ply *ply, unsigned size, uint64_t *value)
{
    if ((size_t)(ply->text.end - ply->at) < size)
        return tia_ply_error(ply, "the file ends here, expected more numbers");
    *value = tia_binary_unsigned(ply->at, size, ply->big_endian);
    ply->at += size;
    return TIA_OK;
}

int tia_ply_skip(struct ply *ply, uint8_t type)
{
    uint64_t unused;

    return take(ply, size_of(type), &unused);
}

static int read_binary(struct ply *ply, uint8_t type, unsigned bits, int64_t *out)
{
    uint64_t value = 0;
    int status = take(ply, size_of(type), &value);

    if (status)
        return status;
    switch (convert(out, value, type, bits)) {
    case TIA_DECIMAL_FINE:
        return TIA_OK;
    case TIA_DECIMAL_NONE:
        return tia_ply_error(ply, "not a number, expected a number below 2147483648");
    default:
        return tia_ply_error(ply, "a number is out of range, expected a number below 2147483648");
    }
}

int tia_ply_number(struct ply *ply, uint8_t type, unsigned bits, int64_t *out)
{
    struct tia_word end;

    if (ply->binary)
        return read_binary(ply, type, bits, out);
    if (tia_text_line(&ply->text))
        return tia_text_long(&ply->text, out, bits);
    (void)tia_text_word(&ply->text, &end);
    return tia_ply_error(ply, "the file ends here, expected more numbers");
}
