# What a remedy asks the user to do, as :/drawings/NAME.svg. The four colors in the files stand for those
# of the theme: text, secondary text, accent, warning.
file(GLOB drawing_files CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/*.svg)
qt_add_resources(sd_ui drawings PREFIX /drawings BASE ${CMAKE_CURRENT_LIST_DIR} FILES ${drawing_files} ${SERVODESK_RCC})
