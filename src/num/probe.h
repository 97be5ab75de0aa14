/* probe.h - preprocessed by the Makefile; yields "yes" if num_f128.h compiles and its functions link. */
#include <stdint.h> /* with the GNU C library it says so */
#if (defined __LDBL_MANT_DIG__ && __LDBL_MANT_DIG__ == 113) ||                                                         \
    (defined __SIZEOF_FLOAT128__ && defined __GLIBC__ && (__GLIBC__ > 2 || __GLIBC_MINOR__ >= 26))
yes
#endif
