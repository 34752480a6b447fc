#include "base/sha256.h"
#include <errno.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

struct sha256 {
    uint32_t h[8];
    uint64_t length; /* bytes taken so far */
    unsigned char block[64];
};

/* FIPS 180-4, 4.2.2: fractional parts of the cube roots of the first 64 primes. */
static const uint32_t round_constant[64] = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2,
};

static uint32_t turned(uint32_t x, unsigned n) { return x >> n | x << (32 - n); }

static uint32_t word_at(const unsigned char *p)
{
    return (uint32_t)p[0] << 24 | (uint32_t)p[1] << 16 | (uint32_t)p[2] << 8 | (uint32_t)p[3];
}

static void take_block(uint32_t h[8], const unsigned char *block)
{
    uint32_t w[64], v[8];
    for (size_t t = 0; t < 16; t++) w[t] = word_at(block + 4 * t);
    for (size_t t = 16; t < 64; t++) {
        uint32_t low = turned(w[t - 15], 7) ^ turned(w[t - 15], 18) ^ w[t - 15] >> 3;
        uint32_t high = turned(w[t - 2], 17) ^ turned(w[t - 2], 19) ^ w[t - 2] >> 10;
        w[t] = w[t - 16] + low + w[t - 7] + high;
    }
    memcpy(v, h, sizeof v);
    for (size_t t = 0; t < 64; t++) {
        uint32_t mix = turned(v[4], 6) ^ turned(v[4], 11) ^ turned(v[4], 25);
        uint32_t chosen = (v[4] & v[5]) ^ (~v[4] & v[6]);
        uint32_t first = v[7] + mix + chosen + round_constant[t] + w[t];
        uint32_t spread = turned(v[0], 2) ^ turned(v[0], 13) ^ turned(v[0], 22);
        uint32_t majority = (v[0] & v[1]) ^ (v[0] & v[2]) ^ (v[1] & v[2]);
        memmove(v + 1, v, 7 * sizeof v[0]);
        v[4] += first;
        v[0] = first + spread + majority;
    }
    for (size_t i = 0; i < 8; i++) h[i] += v[i];
}

static void begin(struct sha256 *s)
{
    /* FIPS 180-4, 5.3.3: fractional parts of the square roots of the first 8 primes. */
    static const uint32_t start[8] = { 0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                       0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19 };
    memcpy(s->h, start, sizeof start);
    s->length = 0;
}

static void take(struct sha256 *s, const unsigned char *bytes, size_t size)
{
    while (size > 0) {
        size_t filled = s->length % 64, n = size < 64 - filled ? size : 64 - filled;
        memcpy(s->block + filled, bytes, n);
        s->length += n;
        bytes += n;
        size -= n;
        if (s->length % 64 == 0) take_block(s->h, s->block);
    }
}

static void finish(struct sha256 *s, char text[static WF_SHA256_TEXT])
{
    static const unsigned char padding[64] = { 0x80 };
    uint64_t bits = s->length * 8;
    unsigned char length[8];
    for (unsigned i = 0; i < 8; i++) length[i] = (unsigned char)(bits >> (56 - 8 * i));
    take(s, padding, 1 + (119 - s->length % 64) % 64);
    take(s, length, sizeof length);
    for (size_t i = 0; i < 8; i++) snprintf(text + 8 * i, 9, "%08x", (unsigned)s->h[i]);
}

void wf_sha256(const void *bytes, size_t size, char text[static WF_SHA256_TEXT])
{
    struct sha256 s;
    begin(&s);
    take(&s, bytes, size);
    finish(&s, text);
}

enum wf_status wf_sha256_file(const char *path, char text[static WF_SHA256_TEXT], struct wf_err *e)
{
    unsigned char piece[16384];
    struct sha256 s;
    FILE *f = fopen(path, "rb");
    if (!f) return wf_fail(e, WF_EINPUT, "%s: cannot be read: %s", path, strerror(errno));
    begin(&s);
    for (size_t n; (n = fread(piece, 1, sizeof piece, f)) > 0;) take(&s, piece, n);
    int error = ferror(f) ? errno : 0;
    fclose(f);
    if (error) return wf_fail(e, WF_EINPUT, "%s: cannot be read: %s", path, strerror(error));
    finish(&s, text);
    return WF_OK;
}
