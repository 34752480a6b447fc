/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_TESTS_MAT_FILES_H
#define WF_TESTS_MAT_FILES_H
/* MATLAB files of a small tree, written by libmatio, and ways of damaging files. */
#include <matio.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Stem 1 m and 0.5 m, a branch of 0.5 m at 1 m; coordinates of a plot. */
static float radius[] = { 0.05F, 0.04F, 0.02F }, length[] = { 1, 0.5F, 0.5F };
static float start[] = { 4, 4, 4, 19, 19, 19, 0.6F, 1.6F, 1.6F },
             axis[] = { 0, 0, 0.6F, 0, 0, 0, 1, 1, 0.8F };
static uint32_t parent[] = { 0, 1, 1 }, extension[] = { 2, 0, 0 };
static uint8_t order[] = { 0, 0, 1 }, added[] = { 0, 0, 1 };

static inline matvar_t *column(enum matio_classes c, enum matio_types type, size_t width, void *data)
{
    return Mat_VarCreate(NULL, c, type, 2, (size_t[]){ 3, width }, data, 0);
}

static inline matvar_t *cylinder(const char *name)
{
    static const char *fields[] = { "radius", "length",    "start", "axis",
                                    "parent", "extension", "added", "BranchOrder" };
    matvar_t *s = Mat_VarCreateStruct(name, 2, (size_t[]){ 1, 1 }, fields, 8);
    matvar_t *part[] = {
        column(MAT_C_SINGLE, MAT_T_SINGLE, 1, radius), column(MAT_C_SINGLE, MAT_T_SINGLE, 1, length),
        column(MAT_C_SINGLE, MAT_T_SINGLE, 3, start),  column(MAT_C_SINGLE, MAT_T_SINGLE, 3, axis),
        column(MAT_C_UINT32, MAT_T_UINT32, 1, parent), column(MAT_C_UINT32, MAT_T_UINT32, 1, extension),
        column(MAT_C_UINT8, MAT_T_UINT8, 1, added),    column(MAT_C_UINT8, MAT_T_UINT8, 1, order)
    };
    for (size_t k = 0; k < 8; k++) Mat_VarSetStructFieldByName(s, fields[k], 0, part[k]);
    return s;
}

/* A number, and a structure QSM with so many models of the tree. Given: MAT_FT_MAT5 or MAT_FT_MAT73. */
static inline void mat_write(const char *path, enum mat_ft version, enum matio_compression packed,
                             size_t models)
{
    double other = 1;
    mat_t *mat = Mat_CreateVer(path, NULL, version);
    assert_non_null(mat);
    matvar_t *first = Mat_VarCreate("inputs", MAT_C_DOUBLE, MAT_T_DOUBLE, 2, (size_t[]){ 1, 1 }, &other, 0);
    matvar_t *qsm = Mat_VarCreateStruct("QSM", 2, (size_t[]){ 1, models }, (const char *[]){ "cylinder" }, 1);
    for (size_t k = 0; k < models; k++) Mat_VarSetStructFieldByName(qsm, "cylinder", k, cylinder(NULL));
    assert_int_equal(Mat_VarWrite(mat, first, MAT_COMPRESSION_NONE), 0);
    assert_int_equal(Mat_VarWrite(mat, qsm, packed), 0);
    Mat_VarFree(first);
    Mat_VarFree(qsm);
    assert_int_equal(Mat_Close(mat), 0);
}

struct file {
    unsigned char *bytes;
    size_t size;
};

static inline struct file file_load(const char *path)
{
    struct file f = { NULL, 0 };
    FILE *from = fopen(path, "rb");
    assert_non_null(from);
    assert_int_equal(fseek(from, 0, SEEK_END), 0);
    f.size = (size_t)ftell(from);
    rewind(from);
    assert_non_null(f.bytes = malloc(f.size + 1));
    assert_int_equal(fread(f.bytes, 1, f.size, from), f.size);
    fclose(from);
    return f;
}

static inline void file_save(const char *path, const struct file *f)
{
    FILE *to = fopen(path, "wb");
    assert_non_null(to);
    assert_int_equal(fwrite(f->bytes, 1, f->size, to), f->size);
    assert_int_equal(fclose(to), 0);
}

/* The same sequence everywhere: xorshift, Marsaglia 2003. */
static inline uint32_t chance(uint32_t *seed, uint32_t below)
{
    *seed ^= *seed << 13, *seed ^= *seed >> 17, *seed ^= *seed << 5;
    return *seed % below;
}

/* Change one to three places of f from byte `from` on: a bit, a byte, a word of large or small numbers, a
 * copy of other bytes; sometimes cut the end off. */
static inline void file_damage(struct file *f, size_t from, uint32_t *seed)
{
    for (uint32_t n = 1 + chance(seed, 3); n; n--) {
        size_t room = f->size - from, at = from + chance(seed, (uint32_t)room), size = 1;
        unsigned char *p = f->bytes + at;
        switch (chance(seed, 6)) {
        case 0:
            *p ^= (unsigned char)(1U << chance(seed, 8));
            break;
        case 1:
            *p = (unsigned char)chance(seed, 256);
            break;
        case 2:
            *p = (unsigned char)(*p + 1);
            break;
        case 3:
            size = 1 + chance(seed, 8);
            memset(p, chance(seed, 2) ? 0xFF : 0, at + size > f->size ? f->size - at : size);
            break;
        case 4:
            size = 1 + chance(seed, 16);
            if (at + size <= f->size)
                memmove(p, f->bytes + from + chance(seed, (uint32_t)(room - size)), size);
            break;
        default:
            if (!chance(seed, 8)) f->size = at + 1;
        }
    }
}
#endif
