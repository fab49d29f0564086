# velarium_shaders(TARGET file...): compiles each `name.stage.glsl` (stage: vert, frag, comp) to SPIR-V for Vulkan 1.3
# and writes it as a C++ initialiser list to shaders/FOLDER/name.stage.inc, on the target's include path; FOLDER is the
# file's, as it was named. `file:NAME=DEFINE[,DEFINE]` makes a variant shaders/FOLDER/NAME.inc with those macros.
function(velarium_shaders target)
  # glslc does not escape spaces in its dependency files: relative names keep the tree's own path out of them.
  # CMake reads them relative to the current binary folder (CMP0116).
  file(RELATIVE_PATH include_root ${CMAKE_CURRENT_BINARY_DIR} ${PROJECT_SOURCE_DIR}/src)
  foreach(entry IN LISTS ARGN)
    string(REPLACE ":" ";" parts "${entry}")
    list(GET parts 0 file)
    get_filename_component(name ${file} NAME)
    string(REGEX MATCH "\\.(vert|frag|comp)\\.glsl$" stage "${name}")
    set(stage ${CMAKE_MATCH_1})
    string(REGEX REPLACE "\\.glsl$" "" out "${name}")
    set(defines "")
    list(LENGTH parts count)
    if(count GREATER 1)
      list(GET parts 1 variant)
      string(REPLACE "=" ";" variant "${variant}")
      list(GET variant 0 out)
      list(GET variant 1 macros)
      string(REPLACE "," ";" macros "${macros}")
      foreach(macro IN LISTS macros)
        list(APPEND defines "-D${macro}")
      endforeach()
    endif()
    set(source ${CMAKE_CURRENT_SOURCE_DIR}/${file})
    get_filename_component(folder ${file} DIRECTORY)
    set(output ${PROJECT_BINARY_DIR}/generated/shaders/${folder}/${out}.inc)
    set_property(GLOBAL APPEND PROPERTY VELARIUM_SHADERS "${source}|${folder}/${out}")
    file(RELATIVE_PATH relative_source ${CMAKE_CURRENT_BINARY_DIR} ${source})
    file(RELATIVE_PATH relative_output ${CMAKE_CURRENT_BINARY_DIR} ${output})
    add_custom_command(
      OUTPUT ${output}
      COMMAND ${GLSLC} --target-env=vulkan1.3 -O -Werror -mfmt=c -fshader-stage=${stage} ${defines}
              -I ${include_root} -MD -MF ${relative_output}.d -MT ${relative_output} -o ${relative_output} ${relative_source}
      WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}
      DEPENDS ${source}
      DEPFILE ${output}.d
      COMMENT "glslc ${out}"
      VERBATIM)
    target_sources(${target} PRIVATE ${output})
  endforeach()
  target_include_directories(${target} PRIVATE ${PROJECT_BINARY_DIR}/generated)
endfunction()
