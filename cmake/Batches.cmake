# polhode_batch(TARGET): with POLHODE_BATCHES, compiles the target's sources in batches. A batch is
# one directory, or a part of one of up to batch_bytes. Most of what a source costs is in the headers
# that it reads; a batch reads them once.
#
# Sources of one directory therefore share their unnamed namespaces: give helpers names of their own.
# The presets without POLHODE_BATCHES compile each source alone, which shows a missing #include.
set(batch_bytes 65000)

function(polhode_batch target)
  if(NOT POLHODE_BATCHES)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    if(NOT source MATCHES "\\.cpp$" OR source MATCHES "\\$<" OR NOT EXISTS "${source}")
      continue()
    endif()
    get_filename_component(directory "${source}" DIRECTORY)
    file(RELATIVE_PATH name "${PROJECT_SOURCE_DIR}" "${directory}")
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
    set_property(SOURCE "${source}" PROPERTY UNITY_GROUP "${name}_${part_${name}}")
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()
