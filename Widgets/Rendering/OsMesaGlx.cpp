// The five GLX functions that VTK's OpenGL loader asks for, answered from OSMesa. Compiled into executables
// that render without a display, and into no library: see Resources/CMake/FalciformOffscreen.cmake.
#include <GL/osmesa.h>

#include <cstring>

#define FALCIFORM_EXPORT extern "C" __attribute__((visibility("default")))

FALCIFORM_EXPORT void* glXGetCurrentDisplay() {
  static int display;
  return &display;
}

FALCIFORM_EXPORT int glXQueryVersion(void*, int* major, int* minor) {
  *major = 1;
  *minor = 4;
  return 1;
}

FALCIFORM_EXPORT const char* glXGetClientString(void*, int) { return ""; }

FALCIFORM_EXPORT OSMESAproc glXGetProcAddressARB(const unsigned char* name) {
  const char* text = reinterpret_cast<const char*>(name);
  if (!std::strcmp(text, "glXGetCurrentDisplay")) return reinterpret_cast<OSMESAproc>(&glXGetCurrentDisplay);
  return OSMesaGetProcAddress(text);
}

FALCIFORM_EXPORT OSMESAproc glXGetProcAddress(const unsigned char* name) {
  return glXGetProcAddressARB(name);
}
