/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/picture.h"
#include "base/text.h"
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

const char *wf_picture_address(const struct wf_bytes *jpeg, struct wf_arena *a)
{
    const char *text = wf_base64(jpeg->data, jpeg->size, a);
    return text ? wf_arena_print(a, "data:image/jpeg;base64,%s", text) : NULL;
}

#ifndef WF_PICTURES

enum wf_status wf_picture_take(const char *path, struct wf_arena *a, struct wf_bytes *out, struct wf_err *e)
{
    (void)a, (void)out;
    return wf_fail(e, WF_EMISSING,
                   "%s: this windfirm was built without libjpeg and libpng, so that pictures cannot be freed "
                   "of what cameras write into them: install the packages libjpeg-dev and libpng-dev and "
                   "build it again",
                   path);
}

#else

#include <jpeglib.h>
#include <png.h>
#include <setjmp.h>

/* Red, green, blue of every pixel, by rows. Turned and reduced in place of the first. */
struct pixels {
    size_t w, h;
    unsigned char *rgb; /* of malloc */
};

/* What libjpeg is called with, and where it jumps to when it fails. */
struct jpeg_work {
    struct jpeg_error_mgr errors; /* comes first: errors are found by it */
    jmp_buf out;
    struct jpeg_decompress_struct in;
    struct jpeg_compress_struct to;
    struct jpeg_progress_mgr progress;
    unsigned char *bytes; /* encoded, of malloc */
    unsigned long size;
    struct pixels p;
};

static void jpeg_fails(j_common_ptr x) { longjmp(((struct jpeg_work *)(void *)x->err)->out, 1); }
static void jpeg_says(j_common_ptr x) { (void)x; }
/* A small file of very many scans would take minutes. */
static void jpeg_goes_on(j_common_ptr x)
{
    enum { SCANS = 200 };
    if (((j_decompress_ptr)x)->input_scan_number > SCANS) jpeg_fails(x);
}

static struct jpeg_work *jpeg_new(void)
{
    struct jpeg_work *w = calloc(1, sizeof *w);
    if (!w) return NULL;
    w->in.err = w->to.err = jpeg_std_error(&w->errors);
    w->errors.error_exit = jpeg_fails;
    w->errors.output_message = jpeg_says;
    w->progress.progress_monitor = jpeg_goes_on;
    return w;
}

/* Two or four bytes of Exif, in its own order. */
static size_t exif_number(const unsigned char *p, size_t n, bool big)
{
    size_t x = 0;
    for (size_t i = 0; i < n; i++) x = x << 8 | p[big ? i : n - 1 - i];
    return x;
}

/* How the camera was held: 1 to 8 of Exif's tag 0x0112; 1 where nothing says so. */
static int held(const unsigned char *p, size_t n)
{
    if (n < 14 || memcmp(p, "Exif\0", 6) != 0) return 1;
    p += 6, n -= 6;
    bool big = p[0] == 'M';
    size_t at = exif_number(p + 4, 4, big);
    if (at > n - 2) return 1;
    size_t tags = exif_number(p + at, 2, big);
    for (size_t i = 0; i < tags && at + 14 + 12 * i <= n; i++) {
        const unsigned char *tag = p + at + 2 + 12 * i;
        size_t x = exif_number(tag + 8, 2, big);
        if (exif_number(tag, 2, big) == 0x0112) return x >= 1 && x <= 8 ? (int)x : 1;
    }
    return 1;
}

/* Decode; *turn: how the camera was held. Returned: whether it could be. */
static bool jpeg_read(struct jpeg_work *w, const struct wf_bytes *file, int *turn)
{
    if (setjmp(w->out)) return jpeg_destroy_decompress(&w->in), false;
    jpeg_create_decompress(&w->in);
    jpeg_mem_src(&w->in, (const unsigned char *)file->data, (unsigned long)file->size);
    jpeg_save_markers(&w->in, JPEG_APP0 + 1, 0xffff);
    (void)jpeg_read_header(&w->in, TRUE);
    if ((size_t)w->in.image_width * w->in.image_height > WF_PICTURE_PIXELS) jpeg_fails((j_common_ptr)&w->in);
    for (jpeg_saved_marker_ptr m = w->in.marker_list; m && *turn == 1; m = m->next)
        *turn = held(m->data, m->data_length);
    w->in.progress = &w->progress;
    w->in.out_color_space = JCS_RGB;
    JDIMENSION side = w->in.image_width > w->in.image_height ? w->in.image_width : w->in.image_height;
    for (w->in.scale_denom = 1; w->in.scale_denom < 8 && side / w->in.scale_denom >= 2 * WF_PICTURE_SIDE;)
        w->in.scale_denom *= 2;
    w->in.scale_num = 1;
    (void)jpeg_start_decompress(&w->in);
    w->p = (struct pixels){ w->in.output_width, w->in.output_height, NULL };
    w->p.rgb = malloc(3 * w->p.w * w->p.h);
    if (!w->p.rgb || w->in.output_components != 3) jpeg_fails((j_common_ptr)&w->in);
    while (w->in.output_scanline < w->in.output_height) {
        unsigned char *row = w->p.rgb + 3 * w->p.w * w->in.output_scanline;
        (void)jpeg_read_scanlines(&w->in, &row, 1);
    }
    (void)jpeg_finish_decompress(&w->in);
    bool whole = w->errors.num_warnings == 0; /* a file that ends early is filled with grey */
    jpeg_destroy_decompress(&w->in);
    return whole;
}

static bool jpeg_write(struct jpeg_work *w, const struct pixels *p)
{
    if (setjmp(w->out)) return jpeg_destroy_compress(&w->to), false;
    jpeg_create_compress(&w->to);
    jpeg_mem_dest(&w->to, &w->bytes, &w->size);
    w->to.image_width = (JDIMENSION)p->w, w->to.image_height = (JDIMENSION)p->h;
    w->to.input_components = 3, w->to.in_color_space = JCS_RGB;
    jpeg_set_defaults(&w->to);
    jpeg_set_quality(&w->to, 88, TRUE);
    jpeg_start_compress(&w->to, TRUE);
    while (w->to.next_scanline < w->to.image_height) {
        unsigned char *row = p->rgb + 3 * p->w * w->to.next_scanline;
        (void)jpeg_write_scanlines(&w->to, &row, 1);
    }
    jpeg_finish_compress(&w->to);
    jpeg_destroy_compress(&w->to);
    return true;
}

static bool png_read(const struct wf_bytes *file, struct pixels *p)
{
    png_image image = { .version = PNG_IMAGE_VERSION };
    const png_color white = { 255, 255, 255 };
    bool read = png_image_begin_read_from_memory(&image, file->data, file->size) &&
                (size_t)image.width * image.height <= WF_PICTURE_PIXELS;
    if (read) {
        image.format = PNG_FORMAT_RGB;
        *p = (struct pixels){ image.width, image.height, malloc(PNG_IMAGE_SIZE(image)) };
        read = p->rgb && png_image_finish_read(&image, &white, p->rgb, 0, NULL);
    }
    png_image_free(&image);
    return read;
}

/* A picture of its own, turned as the camera was held, every `by` pixels each way made one. NULL: no memory.
 */
static unsigned char *turned(const struct pixels *p, int held_as, size_t by, size_t w, size_t h)
{
    bool swap = held_as > 4, left = (held_as - 1) % 4 == 1 || (held_as - 1) % 4 == 2;
    bool mirror_x = swap ? held_as == 6 || held_as == 7 : left,
         mirror_y = swap ? held_as == 7 || held_as == 8 : held_as == 3 || held_as == 4;
    unsigned char *out = malloc(3 * w * h);
    for (size_t y = 0; out && y < h; y++)
        for (size_t x = 0; x < w; x++) {
            size_t sum[3] = { 0 }, u = mirror_x ? w - 1 - x : x, v = mirror_y ? h - 1 - y : y;
            size_t column = (swap ? v : u) * by, row = (swap ? u : v) * by;
            for (size_t i = 0; i < by * by; i++)
                for (size_t c = 0; c < 3; c++)
                    sum[c] += p->rgb[3 * ((row + i / by) * p->w + column + i % by) + c];
            for (size_t c = 0; c < 3; c++) out[3 * (y * w + x) + c] = (unsigned char)(sum[c] / (by * by));
        }
    return out;
}

static bool turn_and_reduce(struct pixels *p, int held_as)
{
    size_t side = p->w > p->h ? p->w : p->h, by = (side + WF_PICTURE_SIDE - 1) / WF_PICTURE_SIDE;
    if (by > p->w) by = p->w;
    if (by > p->h) by = p->h;
    if (by < 1) return false;
    size_t w = (held_as > 4 ? p->h : p->w) / by, h = (held_as > 4 ? p->w : p->h) / by;
    unsigned char *out = turned(p, held_as, by, w, h);
    free(p->rgb);
    *p = (struct pixels){ w, h, out };
    return out;
}

/* The file's bytes, where it may be a picture at all. */
static enum wf_status read_file(const char *path, struct wf_arena *a, struct wf_bytes *out, struct wf_err *e)
{
    struct stat s;
    if (!stat(path, &s) && S_ISREG(s.st_mode) && s.st_size > WF_PICTURE_BYTES)
        return wf_fail(e, WF_EINPUT, "%s: a picture of more than 20 MB; give a smaller one", path);
    if (wf_file_read(path, a, out, e)) return e->code;
    if (out->size > WF_PICTURE_BYTES)
        return wf_fail(e, WF_EINPUT, "%s: a picture of more than 20 MB; give a smaller one", path);
    return WF_OK;
}

enum wf_status wf_picture_take(const char *path, struct wf_arena *a, struct wf_bytes *out, struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    struct wf_bytes file = { 0 };
    struct jpeg_work *w = jpeg_new();
    int turn = 1;
    enum wf_status s = w ? read_file(path, &scratch, &file, e) : wf_fail(e, WF_ENOMEM, "%s: no memory", path);
    bool jpeg = !s && file.size > 3 && !memcmp(file.data, "\xff\xd8\xff", 3),
         png = !s && file.size > 8 && !memcmp(file.data, "\x89PNG\r\n\x1a\n", 8);
    if (!s && !jpeg && !png)
        s = wf_fail(e, WF_EINPUT, "%s: is neither a PNG nor a JPEG picture; allowed are these two", path);
    if (!s && !(jpeg ? jpeg_read(w, &file, &turn) : png_read(&file, &w->p)))
        s = wf_fail(e, WF_EINPUT,
                    "%s: cannot be read as a picture: it is damaged, or of more than 40 megapixels", path);
    if (!s && (!turn_and_reduce(&w->p, turn) || !jpeg_write(w, &w->p)))
        s = wf_fail(e, WF_ENOMEM, "%s: not enough memory for the picture", path);
    char *kept = s ? NULL : WF_TAKE(a, w->size, char);
    if (!s && !kept) s = wf_fail(e, WF_ENOMEM, "%s: not enough memory for the picture", path);
    if (kept) memcpy(kept, w->bytes, w->size), *out = (struct wf_bytes){ .data = kept, .size = w->size };
    if (w) free(w->p.rgb), free(w->bytes);
    free(w);
    wf_arena_free(&scratch);
    return s;
}
#endif
