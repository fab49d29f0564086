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
velarium_swiftshader_test(graph_device)
velarium_swiftshader_test(furnace)
velarium_swiftshader_test(bake --gtest_filter=*.AConstantStaysConstant)  # all of them take two minutes
velarium_swiftshader_test(pictures)
velarium_swiftshader_test(golden)
# The longest start first. SwiftShader compiles pipelines on one processor, which leaves the others to other tests.
set_tests_properties(swiftshader_pictures swiftshader_golden PROPERTIES COST 1000)
set_tests_properties(swiftshader_golden PROPERTIES
                     ENVIRONMENT VELARIUM_GOLDEN_OUT=${CMAKE_CURRENT_BINARY_DIR}/golden_on_swiftshader)
