# find_package(tia 0.1 REQUIRED), then target_link_libraries(PROGRAM tia::tia). Targets:
#
#   tia::tia       the shared library: the core and the vector units
#   tia::static    the same, static
#   tia::radio     static, paths of radio waves
#
# Those whose library is not installed, as the shared one where there is no operating system, are not there; tia::tia
# then is tia::static.
get_filename_component(tia_libdir "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)
set(tia_prefix "${CMAKE_CURRENT_LIST_DIR}")
while(NOT EXISTS "${tia_prefix}/include/tia/tia.h")
    get_filename_component(tia_above "${tia_prefix}" DIRECTORY)
    if(tia_above STREQUAL tia_prefix)
        set(tia_FOUND FALSE)
        set(tia_NOT_FOUND_MESSAGE "no include/tia/tia.h above ${CMAKE_CURRENT_LIST_DIR}")
        return()
    endif()
    set(tia_prefix "${tia_above}")
endwhile()

function(tia_library name kind file)
    if(NOT TARGET tia::${name} AND EXISTS "${file}")
        add_library(tia::${name} ${kind} IMPORTED)
        set_target_properties(tia::${name} PROPERTIES IMPORTED_LOCATION "${file}"
            INTERFACE_INCLUDE_DIRECTORIES "${tia_prefix}/include" ${ARGN})
    endif()
endfunction()

tia_library(tia SHARED "${tia_libdir}/libtia.so.0" IMPORTED_SONAME libtia.so.0)
if(EXISTS "${tia_libdir}/libtia-simd.a")
    # The levels need the core, too.
    tia_library(static STATIC "${tia_libdir}/libtia.a"
        INTERFACE_LINK_LIBRARIES "${tia_libdir}/libtia-simd.a;${tia_libdir}/libtia.a;m")
else()
    tia_library(static STATIC "${tia_libdir}/libtia.a")
endif()
if(TARGET tia::static)
    tia_library(radio STATIC "${tia_libdir}/libtia-radio.a" INTERFACE_LINK_LIBRARIES tia::static)
endif()
if(NOT TARGET tia::tia)
    tia_library(tia STATIC "${tia_libdir}/libtia.a")
endif()
