# The Debian package: what is installed where, and what dpkg says of it. packaging/release.sh makes and tries it.
include(GNUInstallDirs)
install(TARGETS servodesk servodesk-cli servodesk-sim)
set(here ${CMAKE_SOURCE_DIR}/packaging/linux)
install(FILES ${here}/servodesk.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES ${here}/servodesk-mime.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages RENAME servodesk.xml)
install(FILES ${CMAKE_SOURCE_DIR}/resources/icons/servodesk.svg
        DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)

# The manual pages are made of what the programs say of themselves.
option(SERVODESK_PACKAGE "Make manual pages, and install udev rules, for the Debian package" OFF)
if(NOT SERVODESK_PACKAGE)
    return()
endif()
find_package(Python3 REQUIRED COMPONENTS Interpreter)
find_program(HELP2MAN help2man REQUIRED)
find_program(GZIP gzip REQUIRED)
set(docs ${CMAKE_BINARY_DIR}/docs)
set(pages)
foreach(program servodesk servodesk-cli servodesk-sim)
    list(APPEND pages ${docs}/${program}.1)
endforeach()
# The dates of the package are those of the latest commit.
foreach(part "date aD" "day as" "epoch ct")
    separate_arguments(part)
    list(GET part 0 name)
    list(GET part 1 format)
    execute_process(COMMAND git -C ${CMAKE_SOURCE_DIR} log -1 --format=%${format} OUTPUT_VARIABLE ${name}
                    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endforeach()
if(NOT epoch)
    message(FATAL_ERROR "The package is made from a git checkout: its dates are those of the latest commit.")
endif()
add_custom_command(OUTPUT ${pages}
    COMMAND ${CMAKE_COMMAND} -E env SOURCE_DATE_EPOCH=${epoch}
            ${Python3_EXECUTABLE} ${here}/generate-docs.py $<TARGET_FILE_DIR:servodesk> ${docs}
    COMMAND ${GZIP} -9nkf ${pages}
    DEPENDS servodesk servodesk-cli servodesk-sim ${here}/generate-docs.py VERBATIM)
set(maintainer "ServoDesk developers <developers@servodesk.invalid>")
configure_file(${here}/changelog.in ${docs}/changelog @ONLY)
configure_file(${here}/servodesk.metainfo.xml.in ${docs}/org.servodesk.servodesk.metainfo.xml @ONLY)
add_custom_command(OUTPUT ${docs}/changelog.gz COMMAND ${GZIP} -9nkf ${docs}/changelog
                   DEPENDS ${docs}/changelog VERBATIM)
add_custom_target(docs ALL DEPENDS ${pages} ${docs}/changelog.gz)

list(TRANSFORM pages APPEND .gz)
install(FILES ${pages} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${here}/completions/servodesk-cli.bash RENAME servodesk-cli
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${here}/completions/_servodesk-cli DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
install(FILES ${here}/completions/servodesk-cli.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
install(FILES ${docs}/org.servodesk.servodesk.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
install(FILES ${docs}/changelog.gz ${here}/copyright ${CMAKE_SOURCE_DIR}/README.md
        DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/servodesk)
install(FILES ${here}/60-servodesk.rules ${here}/91-servodesk-brltty.rules DESTINATION lib/udev/rules.d)

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
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${here}/postinst)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION electronics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# A plugin, which is not linked: the history is an SQLite file.
set(CPACK_DEBIAN_PACKAGE_DEPENDS libqt6sql6-sqlite)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "fonts-noto-cjk, libqt6sql6-psql, qt6-translations-l10n, qt6-wayland")
include(CPack)
