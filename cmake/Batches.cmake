# polhode_batch(TARGET [BYTES]): with POLHODE_BATCHES, compiles the target's sources in batches. A
# batch is one room (a directory of the second level, such as src/quadrature), or a part of one of
# up to BYTES (90000: some 20 seconds). Most of what a source costs is in the headers that it reads;
# a batch reads them once. A source with the property SKIP_UNITY_BUILD_INCLUSION, or with include
# directories of its own, is compiled alone; set these before the call.
#
# CMake's unity builds write absolute paths into their sources, so that ccache finds nothing in
# another checkout. These batches include their sources by relative paths.
#
# Sources of one room share their unnamed namespaces: give helpers names of their own.
# The presets without POLHODE_BATCHES compile each source alone, which shows a missing #include.
function(polhode_batch target)
  if(NOT POLHODE_BATCHES)
    return()
  endif()
  set(batch_bytes 90000)
  if(ARGC GREATER 1)
    set(batch_bytes ${ARGV1})
  endif()
  set(batches "${PROJECT_BINARY_DIR}/batches/${target}")
  get_target_property(sources ${target} SOURCES)
  set(kept)
  set(names)
  foreach(source IN LISTS sources)
    get_source_file_property(alone "${source}" SKIP_UNITY_BUILD_INCLUSION)
    get_source_file_property(directories "${source}" INCLUDE_DIRECTORIES)
    if(alone OR directories OR NOT source MATCHES "\\.cpp$" OR source MATCHES "\\$<"
       OR NOT EXISTS "${source}")
      list(APPEND kept "${source}")
      continue()
    endif()
    get_filename_component(directory "${source}" DIRECTORY)
    file(RELATIVE_PATH name "${PROJECT_SOURCE_DIR}" "${directory}")
    string(REGEX REPLACE "^([^/]+/[^/]+)/.*" "\\1" name "${name}")
    string(MAKE_C_IDENTIFIER "${name}" name)
    file(SIZE "${source}" bytes)
    if(NOT DEFINED part_${name})
      set(part_${name} 1)
      set(filled_${name} 0)
    endif()
    math(EXPR filled_${name} "${filled_${name}} + ${bytes}")
    if(filled_${name} GREATER batch_bytes AND NOT filled_${name} EQUAL bytes)
      math(EXPR part_${name} "${part_${name}} + 1")
      set(filled_${name} ${bytes})
    endif()
    set(name "${name}_${part_${name}}")
    list(APPEND names ${name})
    file(RELATIVE_PATH included "${batches}" "${source}")
    string(APPEND content_${name} "#include \"${included}\"\n")
  endforeach()
  list(REMOVE_DUPLICATES names)
  foreach(name IN LISTS names)
    file(CONFIGURE OUTPUT "${batches}/${name}.cpp" CONTENT "${content_${name}}" @ONLY)
    list(APPEND kept "${batches}/${name}.cpp")
  endforeach()
  set_property(TARGET ${target} PROPERTY SOURCES ${kept})
endfunction()
