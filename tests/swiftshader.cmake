# Tests that have another opinion to hear: the same programs on a second driver. Skipped where it is not installed.
# Sanitizers watch the same code of ours on lavapipe, and SwiftShader takes long under them.
if(VELARIUM_SANITIZE)
  return()
endif()

function(velarium_swiftshader_test name)
  add_test(NAME swiftshader_${name}
           COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/on_swiftshader.sh $<TARGET_FILE:test_${name}> ${ARGN})
  set_tests_properties(swiftshader_${name} PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 1200)
endfunction()

velarium_swiftshader_test(parity)
velarium_swiftshader_test(display)
velarium_swiftshader_test(furnace)
velarium_swiftshader_test(bake --gtest_filter=*.AConstantStaysConstant)  # all of them take two minutes
# Vertices that snap to 1/16 of a pixel move the surfaces that edges are seen to belong to. So next to edges lights end at
# their volumes not to the bit, and of one shadow test the error is 0.0260 where lavapipe is held to 0.025.
velarium_swiftshader_test(golden "--gtest_filter=-ClipVolumes.EndEachKindOfLight:ClipVolumes.DoNotDependOnWhereTheEyeIs:\
ClipVolumes.HoldFarFromTheOrigin:LocalShadows.ShadowsGoOnAcrossTheFacesOfAPoint")
set_tests_properties(swiftshader_golden PROPERTIES
                     ENVIRONMENT VELARIUM_GOLDEN_OUT=${CMAKE_CURRENT_BINARY_DIR}/golden_on_swiftshader)
