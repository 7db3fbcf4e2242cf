# The smoke test in a real window; one at a time, since it measures an idle one.
add_test(NAME gui.smoke
  COMMAND ${CMAKE_SOURCE_DIR}/tests/gui/smoke.sh $<TARGET_FILE:hanei> ${CMAKE_SOURCE_DIR}/assets/rooms/computer-room-panels.hanei)
set_tests_properties(gui.smoke PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 900 RUN_SERIAL ON)
