# SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
# SPDX-License-Identifier: GPL-3.0-or-later
include(GNUInstallDirs)
install(TARGETS gimbaldesk gimbalctl gimbalsim gimbalguard RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(FILES resources/gimbaldesk.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES resources/70-gimbaldesk.rules DESTINATION lib/udev/rules.d)
