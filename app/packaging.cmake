# SPDX-License-Identifier: GPL-3.0-or-later
# cmake --install, and a Debian package: cmake --workflow --preset package
install(TARGETS psmlab)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/assets ${CMAKE_SOURCE_DIR}/lessons DESTINATION ${CMAKE_INSTALL_DATADIR}/psmlab
        PATTERN desktop EXCLUDE PATTERN pictures EXCLUDE)
install(FILES ${CMAKE_SOURCE_DIR}/assets/desktop/psmlab.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES ${CMAKE_SOURCE_DIR}/assets/desktop/psmlab.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
install(FILES ${CMAKE_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
install(FILES ${CMAKE_SOURCE_DIR}/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME psmlab)
set(CPACK_PACKAGE_CONTACT "psmlab developers <psmlab@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "interactive perspective shadow maps for teaching")
set(CPACK_PACKAGE_DESCRIPTION
    "psmlab shows one shadow-mapping experiment in linked views: world space, the
post-perspective cube, the shadow map, and through the eye. Light and camera
move in every view. The same experiment runs without a display and gives
pictures and numbers.")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION education)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
# The typeface and the drivers are not linked, so dpkg-shlibdeps cannot see them.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "fonts-dejavu-core, libegl1, libgl1, libgl1-mesa-dri")
include(CPack)
