# proofs/coq/beta.jq lets nothing of a certificate into a Coq file but decimal digits. JQ, FILTER,
# CERTIFICATE and WORK are given.

file(MAKE_DIRECTORY "${WORK}")

# Whether the filter takes the certificate after this change.
function(takes change result)
  execute_process(COMMAND "${JQ}" "${change}" "${CERTIFICATE}"
    OUTPUT_FILE "${WORK}/changed.json" RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "jq does not understand ${change}")
  endif()
  execute_process(COMMAND "${JQ}" --raw-output --arg integers Z --argjson digits 50
      --from-file "${FILTER}" "${WORK}/changed.json"
    OUTPUT_VARIABLE output ERROR_VARIABLE error RESULT_VARIABLE status)
  if(status EQUAL 0)
    set(${result} yes PARENT_SCOPE)
    set(output "${output}" PARENT_SCOPE)
  else()
    if(NOT output STREQUAL "")
      message(FATAL_ERROR "refused, yet it wrote: ${output}")
    endif()
    set(${result} no PARENT_SCOPE)
  endif()
endfunction()

takes("." taken)
if(NOT taken OR NOT output MATCHES "Theorem beta_digits" OR NOT output MATCHES "10 \\^ 50 <")
  message(FATAL_ERROR "the certificate as it is was refused:\n${output}")
endif()

set(count 0)
foreach(place IN ITEMS .witness.scale .witness.below.argument .witness.below.start[0] .witness.below.start[1]
    .witness.below.steps[0][0] .witness.below.steps[1][1] .witness.above.argument .witness.above.start[0]
    .witness.above.steps[0][1] .numbers.beta.lower .numbers.beta.upper)
  foreach(text IN ITEMS
      "\"1). Axiom cheat : False. Check (1\"" "(. + \"\\n\")" "(\"1\\n\" + .)" "(. + \" \")" "\"\"" "\"-1\""
      "\"0x10\"" "\"1 2\"" "\"٣\"" "17" "null" "[\"1\"]" "{}")
    takes("${place} = (${place} | ${text})" taken)
    if(taken)
      message(FATAL_ERROR "${place} was let in as ${text}:\n${output}")
    endif()
    math(EXPR count "${count} + 1")
  endforeach()
endforeach()
foreach(change IN ITEMS
    ".numbers.beta.digits = \"50 *) Axiom cheat : False. (*\"" ".numbers.beta.digits = 49" ".claim = \"physical\""
    ".witness.kind = \"another\"" ".witness.below.steps[0] += [\"1\"]" ".witness.below.steps[0] |= .[:1]"
    ".witness.below.steps = \"1\"" ".witness.below.start = {\"0\": \"1\", \"1\": \"2\"}" "del(.witness.scale)"
    ".numbers.beta.lower = \"0.02\\n8\"" ".numbers.beta.lower = \"1.02\"" ".numbers.beta.upper = \"0.\""
    ".numbers.beta.upper = \"2e-2\"")
  takes("${change}" taken)
  if(taken)
    message(FATAL_ERROR "${change} was let in:\n${output}")
  endif()
  math(EXPR count "${count} + 1")
endforeach()
message("${count} forged certificates refused")
