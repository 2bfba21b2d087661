# The build goes on without the pages of scenes, and says in one line why: cmake -DMODULE=…
# -DSOURCE_DIR=… -DDIR=… -P page_modules.cmake

include("${MODULE}")

# An expectation of the reason, given what stands in for node and npm; OFF where there is none.
function(expect_reason NODE NPM EXPECTED)
  file(REMOVE_RECURSE "${DIR}")
  set(NODE_PROGRAM "${NODE}" CACHE STRING "" FORCE)
  set(NPM_PROGRAM "${NPM}" CACHE STRING "" FORCE)
  polhode_install_page_modules("${SOURCE_DIR}" "${DIR}" reason)
  if(NOT reason MATCHES "${EXPECTED}" OR reason MATCHES "\n")
    message(SEND_ERROR "'${reason}' in the place of '${EXPECTED}'")
  endif()
  if(EXISTS "${DIR}/installed")
    message(SEND_ERROR "modules that are not there are said to be")
  endif()
endfunction()

function(write_program NAME TEXT)
  file(WRITE "${DIR}-programs/${NAME}" "#!/bin/sh\n${TEXT}\n")
  file(CHMOD "${DIR}-programs/${NAME}" PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
endfunction()

set(programs "${DIR}-programs")
write_program(node18 "echo v18.20.4")
write_program(node12 "echo v12.22.12")
write_program(no_registry "echo 'npm ERR! network' >&2; exit 1")

expect_reason("OFF" "OFF" "^node and npm are not installed")
expect_reason("${programs}/node18" "OFF" "^node and npm are not installed")
expect_reason("${programs}/node12" "${programs}/no_registry" "^node 18 or later is needed, and this is '12.22.12'")
expect_reason("${programs}/node18" "${programs}/no_registry" "^npm could not install .*npm.log.; configure again")
file(READ "${DIR}/npm.log" log)
if(NOT log MATCHES "npm ERR! network")
  message(SEND_ERROR "what npm said is lost: '${log}'")
endif()
file(REMOVE_RECURSE "${DIR}" "${programs}")
