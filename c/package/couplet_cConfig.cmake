# The targets couplet_c::couplet_c, the shared library, and couplet_c::couplet_c_static, wherever this folder was moved.
get_filename_component(_couplet_c_prefix "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
if(NOT TARGET couplet_c::couplet_c)
  add_library(couplet_c::couplet_c SHARED IMPORTED)
  set_target_properties(couplet_c::couplet_c PROPERTIES
    IMPORTED_LOCATION "${_couplet_c_prefix}/lib/libcouplet_c.so.@NUMBER@"
    IMPORTED_SONAME "libcouplet_c.so.@NUMBER@"
    INTERFACE_INCLUDE_DIRECTORIES "${_couplet_c_prefix}/include")
  add_library(couplet_c::couplet_c_static STATIC IMPORTED)
  set_target_properties(couplet_c::couplet_c_static PROPERTIES
    IMPORTED_LOCATION "${_couplet_c_prefix}/lib/libcouplet_c.a"
    IMPORTED_LINK_INTERFACE_LANGUAGES C
    INTERFACE_LINK_LIBRARIES "m;pthread;dl"
    INTERFACE_INCLUDE_DIRECTORIES "${_couplet_c_prefix}/include")
endif()
