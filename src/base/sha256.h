#ifndef WF_BASE_SHA256_H
#define WF_BASE_SHA256_H
/* Fingerprint of an input file, so that a result can be traced to the bytes it was made from.
 * Source: FIPS PUB 180-4 (NIST, 2015), SHA-256. */
#include "base/err.h"
#include <stddef.h>

enum { WF_SHA256_TEXT = 65 }; /* 64 hexadecimal digits and a NUL */

/* Given: size bytes. Returned in `text`: the digest in lower-case hexadecimal. */
void wf_sha256(const void *bytes, size_t size, char text[static WF_SHA256_TEXT]);

/* The same for a file, read in pieces. Errors: WF_EINPUT naming the path when it cannot be read. */
enum wf_status wf_sha256_file(const char *path, char text[static WF_SHA256_TEXT], struct wf_err *e);
#endif
