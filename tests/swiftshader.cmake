# Tests that have another opinion to hear: the same programs on a second driver. Skipped where it is not installed.
# Sanitizers watch the same code of ours on lavapipe, and SwiftShader takes long under them.
if(VELARIUM_SANITIZE)
  return()
endif()

function(velarium_swiftshader_test name program)
  add_test(NAME swiftshader_${name}
           COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/on_swiftshader.sh $<TARGET_FILE:test_${program}> ${ARGN})
  set_tests_properties(swiftshader_${name} PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 1200)
endfunction()

velarium_swiftshader_test(parity parity)
velarium_swiftshader_test(display display)
velarium_swiftshader_test(graph_device graph_device)
velarium_swiftshader_test(furnace furnace)
velarium_swiftshader_test(bake bake --gtest_filter=*.AConstantStaysConstant)  # all of them take two minutes
# Pictures of shadows, of lights, and all others, each some minutes: SwiftShader compiles a pipeline in seconds, on one
# processor, which leaves the others to other tests. The longest start first.
set(shadows "*Shadow*:*Translucency*")
set(lights "LightVolumes.*:TiledLighting.*:AmbientLights.*:ClipVolumes.*")
velarium_swiftshader_test(pictures_of_shadows pictures --gtest_filter=${shadows})
velarium_swiftshader_test(pictures_of_lights pictures --gtest_filter=${lights})
velarium_swiftshader_test(pictures pictures --gtest_filter=-${shadows}:${lights})
velarium_swiftshader_test(golden golden)
set_tests_properties(swiftshader_pictures_of_shadows PROPERTIES COST 1000)
set_tests_properties(swiftshader_pictures_of_lights swiftshader_pictures swiftshader_golden PROPERTIES COST 500)
set_tests_properties(swiftshader_golden PROPERTIES
                     ENVIRONMENT VELARIUM_GOLDEN_OUT=${CMAKE_CURRENT_BINARY_DIR}/golden_on_swiftshader)
