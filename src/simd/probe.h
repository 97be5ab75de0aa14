/* probe.h - preprocessed by the Makefile with the flags of each instruction set; yields "yes" if the compiler supports
 * the set. */
#if defined __FAST_MATH__ || (defined __FLT_EVAL_METHOD__ && __FLT_EVAL_METHOD__ != 0)
no
#elif (defined ASK_scalar && (!defined __arm__ || defined __ARM_FP) && (!defined __riscv || defined __riscv_flen)) ||  \
    (defined ASK_sse41 && defined __SSE4_1__) || (defined ASK_avx2 && defined __AVX2__ && defined __FMA__) ||          \
    (defined ASK_avx512 && defined __AVX512F__ && defined __AVX512BW__ && defined __AVX512DQ__ &&                      \
     defined __AVX512VL__) ||                                                                                          \
    (defined ASK_neon && defined __ARM_NEON && defined __aarch64__ && !defined __ARM_BIG_ENDIAN) ||                    \
    (defined ASK_neon32 && defined __ARM_NEON && defined __arm__ && !defined __ARM_BIG_ENDIAN) ||                      \
    (defined ASK_rvv && defined __riscv_v && defined __riscv_float_abi_double && __riscv_xlen == 64 &&                 \
     defined __clang__ && __clang_major__ >= 16) ||                                                                    \
    (defined ASK_wasm && defined __wasm_simd128__)
yes
#endif
