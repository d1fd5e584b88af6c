/* detail/build.h: which build of the library this is, and how that shows in its names.
 *
 * Builds of different number types may meet in one program, each source file with headers of one. So every external
 * symbol ends with its build's number type: twd_controller_init is twd_controller_init_float, _double or _fixed to a
 * linker or debugger. Sources keep the plain names: a library's detail/..._names.h lists them. In C++ the
 * declarations stand in an inline namespace of the same name, so that a struct twd_controller of floats and one of
 * doubles are two types. */
#ifndef TWIDDLE_DETAIL_BUILD_H
#define TWIDDLE_DETAIL_BUILD_H

#if defined(TWD_NUMBER_FLOAT) + defined(TWD_NUMBER_DOUBLE) + defined(TWD_NUMBER_FIXED) > 1
#error "one source file has one number type: TWD_NUMBER_FLOAT, TWD_NUMBER_DOUBLE or TWD_NUMBER_FIXED"
#endif

#if defined(TWD_NUMBER_FIXED)
#define TWD_NUMBER_NAME "fixed"
#define TWD_BUILD fixed
#elif defined(TWD_NUMBER_DOUBLE)
#define TWD_NUMBER_NAME "double"
#define TWD_BUILD double
#else
#ifndef TWD_NUMBER_FLOAT
#define TWD_NUMBER_FLOAT
#endif
#define TWD_NUMBER_NAME "float"
#define TWD_BUILD float
#endif

#define TWD_JOIN_TOKENS(name, build) name##_##build
#define TWD_JOIN(name, build) TWD_JOIN_TOKENS(name, build)

/* The symbol that `name` is in this build. */
#define TWD_BUILD_NAME(name) TWD_JOIN(name, TWD_BUILD)

/* The inline namespace of this build, for C++ code that is compiled once a build, too. */
#define TWD_BUILD_NAMESPACE TWD_JOIN(twd, TWD_BUILD)

/* Around all declarations of a header. Standard headers are included before. */
#if defined(TWD_STRICT_TYPES)
/* The strict check compiles the sources, too, as C++, and those define their functions outside of any namespace. */
#define TWD_BEGIN_DECLARATIONS extern "C" {
#define TWD_END_DECLARATIONS }
#elif defined(__cplusplus)
#define TWD_BEGIN_DECLARATIONS                                                                                         \
    inline namespace TWD_BUILD_NAMESPACE                                                                               \
    {                                                                                                                  \
    extern "C" {
#define TWD_END_DECLARATIONS                                                                                           \
    }                                                                                                                  \
    }
#else
#define TWD_BEGIN_DECLARATIONS
#define TWD_END_DECLARATIONS
#endif

#endif
