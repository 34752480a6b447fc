#ifndef WF_SOLVE_WIDE_H
#define WF_SOLVE_WIDE_H
/* WF_WIDE: one object for every machine; the wider registers of newer processors are used where they are
 * found. Without fused multiply-add both give the same digits. */
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define WF_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define WF_WIDE
#endif
#define WF_INLINE static inline __attribute__((always_inline))
#endif
