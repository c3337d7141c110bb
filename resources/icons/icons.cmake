# The icons inside the program, as :/icons/THEME/22/NAME.svg and :/icons/servodesk.svg.
file(GLOB icon_files CONFIGURE_DEPENDS
     ${CMAKE_CURRENT_LIST_DIR}/*.svg
     ${CMAKE_CURRENT_LIST_DIR}/breeze*/index.theme
     ${CMAKE_CURRENT_LIST_DIR}/breeze*/22/*.svg)
qt_add_resources(sd_ui icons PREFIX /icons BASE ${CMAKE_CURRENT_LIST_DIR} FILES ${icon_files} ${SERVODESK_RCC})

# Qt's own words in Chinese, inside the program as :/i18n/qtbase_zh_CN.qm.
get_target_property(qmake_program Qt6::qmake IMPORTED_LOCATION)
execute_process(COMMAND ${qmake_program} -query QT_INSTALL_TRANSLATIONS
                OUTPUT_VARIABLE qt_translations_folder OUTPUT_STRIP_TRAILING_WHITESPACE)
find_file(QTBASE_ZH_CN qtbase_zh_CN.qm PATHS ${qt_translations_folder} REQUIRED NO_DEFAULT_PATH)
qt_add_resources(sd_ui qt_translations PREFIX /i18n BASE ${qt_translations_folder}
    FILES ${QTBASE_ZH_CN} ${SERVODESK_RCC})
