# The help inside the program, as :/help/…: texts and pictures.
file(GLOB help_files CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/*.md
     ${CMAKE_CURRENT_LIST_DIR}/images/*.png)
qt_add_resources(sd_ui help PREFIX /help BASE ${CMAKE_CURRENT_LIST_DIR} FILES ${help_files} ${SERVODESK_RCC})
