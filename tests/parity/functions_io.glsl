// What the shader of the parity test binds.
#ifndef VEL_TESTS_PARITY_FUNCTIONS_IO_GLSL
#define VEL_TESTS_PARITY_FUNCTIONS_IO_GLSL

#include "shading/lang.glsl"

struct FunctionPush {
  uint function;  // the line of functions.def that is evaluated
  uint count;     // samples
};
PUSH(FunctionPush);
TABLE(0, 0, Inputs, vec4 inputs[]);  // three a sample
OUT_TABLE(0, 1, Outputs, vec4 outputs[]);

#endif
