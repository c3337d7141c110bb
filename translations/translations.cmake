# The interface in other languages: each .ts file here becomes a .qm inside the text layer, as
# :/i18n/NAME.qm. `cmake --build build --target update_translations` brings the .ts files up to
# date with the sources; a test fails while they are not, or while an entry is unfinished.
set(SERVODESK_TS_FILES ${CMAKE_SOURCE_DIR}/translations/servodesk_zh_CN.ts
    ${CMAKE_SOURCE_DIR}/translations/servodesk_en.ts) # the plurals of "%n servo(s)"
# With the include folders it knows in which namespace a class is, as tr() does.
set(SERVODESK_LUPDATE ${CMAKE_SOURCE_DIR}/src ${CMAKE_SOURCE_DIR}/ui -I ${CMAKE_SOURCE_DIR} -I ${CMAKE_SOURCE_DIR}/src -no-obsolete -locations none -silent
    CACHE INTERNAL "What lupdate reads and how; the test of the translations does the same")

set(qm_files)
foreach(ts IN LISTS SERVODESK_TS_FILES)
    get_filename_component(name ${ts} NAME_WE)
    set(qm ${CMAKE_BINARY_DIR}/i18n/${name}.qm)
    add_custom_command(OUTPUT ${qm}
        COMMAND ${CMAKE_COMMAND} -E make_directory ${CMAKE_BINARY_DIR}/i18n
        COMMAND Qt6::lrelease -silent ${ts} -qm ${qm}
        DEPENDS ${ts}
        COMMENT "Compiling ${name}.qm"
        VERBATIM)
    list(APPEND qm_files ${qm})
endforeach()
qt_add_resources(sd_text translations PREFIX /i18n BASE ${CMAKE_BINARY_DIR}/i18n
    FILES ${qm_files} ${SERVODESK_RCC})

add_custom_target(update_translations
    COMMAND Qt6::lupdate ${SERVODESK_LUPDATE} -ts ${CMAKE_SOURCE_DIR}/translations/servodesk_zh_CN.ts
    COMMAND Qt6::lupdate ${SERVODESK_LUPDATE} -pluralonly
            -ts ${CMAKE_SOURCE_DIR}/translations/servodesk_en.ts
    COMMENT "Updating the .ts files from the sources"
    VERBATIM)
