# falciform_offscreen_executable(target): lets an executable render without a display through OSMesa.
#
# Debian's VTK asks GLX where the OpenGL functions are. The executable answers that question itself from OSMesa, which
# works only if its own symbols are exported and libOSMesa stands before libGL in the search order: hence ENABLE_EXPORTS and
# the library as a linker option, which comes before all libraries. Never use it on the desktop application: there real
# GLX must answer.
function(falciform_offscreen_executable target)
  target_sources(${target} PRIVATE ${CMAKE_SOURCE_DIR}/Widgets/Rendering/OsMesaGlx.cpp)
  set_target_properties(${target} PROPERTIES ENABLE_EXPORTS ON)
  target_link_options(${target} PRIVATE LINKER:--push-state,--no-as-needed,-lOSMesa,--pop-state)
  target_link_libraries(${target} PRIVATE Falciform::Offscreen)
endfunction()
