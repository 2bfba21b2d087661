# What npm installs for the page of a scene: three.js, which is bundled into the program, and
# esbuild, which bundles it.

# Puts the modules of SOURCE_DIR/package-lock.json into DIR/node_modules, unless they are there.
# WITHOUT becomes empty, or the reason why there are none.
function(polhode_install_page_modules SOURCE_DIR DIR WITHOUT)
  set(least_node 18)
  set(${WITHOUT} "" PARENT_SCOPE)
  find_program(NODE_PROGRAM NAMES node nodejs)
  find_program(NPM_PROGRAM NAMES npm)
  mark_as_advanced(NODE_PROGRAM NPM_PROGRAM)
  if(NOT NODE_PROGRAM OR NOT NPM_PROGRAM)
    set(${WITHOUT} "node and npm are not installed (Debian: nodejs npm)" PARENT_SCOPE)
    return()
  endif()
  execute_process(COMMAND "${NODE_PROGRAM}" --version
    OUTPUT_VARIABLE node_version ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE result)
  string(REGEX REPLACE "^v" "" node_version "${node_version}")
  if(NOT result EQUAL 0 OR node_version VERSION_LESS least_node)
    set(${WITHOUT} "node ${least_node} or later is needed, and this is '${node_version}'" PARENT_SCOPE)
    return()
  endif()

  set(lock "${SOURCE_DIR}/package-lock.json")
  set(installed "${DIR}/installed")
  file(SHA256 "${lock}" wanted)
  if(EXISTS "${installed}")
    file(READ "${installed}" found)
    if(found STREQUAL wanted)
      return()
    endif()
  endif()
  file(MAKE_DIRECTORY "${DIR}")
  file(COPY "${SOURCE_DIR}/package.json" "${lock}" DESTINATION "${DIR}")
  execute_process(
    COMMAND "${NPM_PROGRAM}" ci --ignore-scripts --no-audit --no-fund --no-update-notifier
      --fetch-retries=1 --fetch-retry-mintimeout=1000 --fetch-timeout=20000
    WORKING_DIRECTORY "${DIR}" TIMEOUT 180 RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(NOT result EQUAL 0)
    file(WRITE "${DIR}/npm.log" "${said}")
    set(${WITHOUT} "npm could not install three and esbuild (${DIR}/npm.log); configure again to try again" PARENT_SCOPE)
    return()
  endif()
  file(WRITE "${installed}" "${wanted}")
endfunction()
