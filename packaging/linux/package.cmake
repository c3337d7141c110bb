# The Debian package: what is installed where, and what dpkg says of it. packaging/release.sh makes and tries it.
include(GNUInstallDirs)
install(TARGETS servodesk servodesk-cli servodesk-sim)
set(here ${CMAKE_SOURCE_DIR}/packaging/linux)
install(FILES ${here}/servodesk.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES ${here}/servodesk-mime.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages RENAME servodesk.xml)
install(FILES ${CMAKE_SOURCE_DIR}/resources/icons/servodesk.svg
        DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)

# Manual pages and completions are made of what the programs say of themselves.
option(SERVODESK_PACKAGE "Make manual pages and completions, and install udev rules, for the Debian package" OFF)
if(NOT SERVODESK_PACKAGE)
    return()
endif()
find_package(Python3 REQUIRED COMPONENTS Interpreter)
find_program(HELP2MAN help2man REQUIRED)
find_program(GZIP gzip REQUIRED)
set(docs ${CMAKE_BINARY_DIR}/docs)
set(pages)
foreach(program servodesk servodesk-cli servodesk-sim)
    list(APPEND pages ${docs}/man/${program}.1)
endforeach()
add_custom_command(OUTPUT ${pages}
    COMMAND Python3::Interpreter ${here}/generate-docs.py $<TARGET_FILE_DIR:servodesk> ${docs}
    COMMAND ${GZIP} -9nkf ${pages}
    DEPENDS servodesk servodesk-cli servodesk-sim ${here}/generate-docs.py VERBATIM)
# The changelog of the package refers to the one for users, with the date of the latest commit.
execute_process(COMMAND git -C ${CMAKE_SOURCE_DIR} log -1 --format=%aD OUTPUT_VARIABLE date
                OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
execute_process(COMMAND git -C ${CMAKE_SOURCE_DIR} log -1 --format=%as OUTPUT_VARIABLE day
                OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT date)
    string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
    string(TIMESTAMP day "%Y-%m-%d" UTC)
endif()
set(maintainer "ServoDesk developers <developers@servodesk.invalid>")
configure_file(${here}/changelog.in ${docs}/changelog @ONLY)
configure_file(${here}/servodesk.metainfo.xml.in ${docs}/org.servodesk.servodesk.metainfo.xml @ONLY)
add_custom_command(OUTPUT ${docs}/changelog.gz COMMAND ${GZIP} -9nkf ${docs}/changelog
                   DEPENDS ${docs}/changelog VERBATIM)
add_custom_target(docs ALL DEPENDS ${pages} ${docs}/changelog.gz)

list(TRANSFORM pages APPEND .gz)
install(FILES ${pages} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${docs}/bash/servodesk-cli DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${docs}/zsh/_servodesk-cli DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
install(FILES ${docs}/fish/servodesk-cli.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
install(FILES ${docs}/org.servodesk.servodesk.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
install(FILES ${docs}/changelog.gz ${here}/copyright ${CMAKE_SOURCE_DIR}/README.md
        DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/servodesk)
install(FILES ${here}/60-servodesk.rules ${here}/86-servodesk.rules DESTINATION lib/udev/rules.d)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
    WORLD_READ WORLD_EXECUTE)
set(CPACK_PACKAGE_NAME servodesk)
set(CPACK_PACKAGE_VENDOR ServoDesk)
set(CPACK_PACKAGE_CONTACT ${maintainer})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "bench program for serial bus servos")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"Searches the bus, reads and edits a servo's memory table without losing a
setting, drives servos, watches them on gauges and trend charts, sweeps and
judges them, saves and restores their parameters, calibrates robot arms.
.
For Feetech (SCS, STS, SMS, HLS), SMS Modbus-RTU and Hiwonder LX servos, in
English and Chinese, as a window (servodesk) and on the command line
(servodesk-cli). servodesk-sim is a simulated bus.")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION electronics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# A plugin, which is not linked: the history is an SQLite file.
set(CPACK_DEBIAN_PACKAGE_DEPENDS libqt6sql6-sqlite)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "fonts-noto-cjk, libqt6sql6-psql, qt6-translations-l10n, qt6-wayland")
include(CPack)
