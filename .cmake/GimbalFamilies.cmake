# SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The families of controllers that are built in: GIMBAL_FAMILIES, some of GIMBAL_KNOWN_FAMILIES. Sources see GIMBAL_WITH_NAME.
string(REPLACE ";" ", " known "${GIMBAL_KNOWN_FAMILIES}")
if("${GIMBAL_FAMILIES}" MATCHES "^[; ]*$")
    message(FATAL_ERROR "GIMBAL_FAMILIES names no family; there are: ${known}")
endif()
foreach(family IN LISTS GIMBAL_FAMILIES)
    if(NOT family IN_LIST GIMBAL_KNOWN_FAMILIES)
        message(FATAL_ERROR "GIMBAL_FAMILIES: there is no family '${family}'; there are: ${known}")
    endif()
    string(TOUPPER ${family} upper)
    target_compile_definitions(gimbal_options INTERFACE GIMBAL_WITH_${upper}=1)
endforeach()

# gimbal_has_families(result names...): whether all of these are built in.
function(gimbal_has_families result)
    set(${result} TRUE PARENT_SCOPE)
    foreach(family ${ARGN})
        if(NOT family IN_LIST GIMBAL_KNOWN_FAMILIES)
            message(FATAL_ERROR "There is no family '${family}'; there are: ${GIMBAL_KNOWN_FAMILIES}")
        elseif(NOT family IN_LIST GIMBAL_FAMILIES)
            set(${result} FALSE PARENT_SCOPE)
        endif()
    endforeach()
endfunction()

# gimbal_family(name folders...): the family's folders, and others that only it needs, if it is built in. Its simulated board is added
# to GIMBAL_FAMILY_BOARDS.
set(GIMBAL_FAMILY_BOARDS)
function(gimbal_family name)
    gimbal_has_families(wanted ${name})
    if(NOT wanted)
        return()
    endif()
    foreach(folder ${ARGN})
        gimbal_folder(${folder} protocol/base)
    endforeach()
    gimbal_folder(protocol/${name} protocol/device ${ARGN})
    gimbal_folder(protocol/simulator/${name} protocol/simulator/world protocol/${name})
    set(GIMBAL_FAMILY_BOARDS ${GIMBAL_FAMILY_BOARDS} protocol/simulator/${name} PARENT_SCOPE)
endfunction()

# gimbal_family_pages(names...): the pages that only boards of these families have, if there are any.
function(gimbal_family_pages)
    set(folders)
    foreach(name ${ARGN})
        if(EXISTS ${CMAKE_SOURCE_DIR}/app/families/${name})
            gimbal_folder(app/families/${name} app/workspace)
            list(APPEND folders app/families/${name})
        endif()
    endforeach()
    gimbal_folder(app/families app/workspace ${folders})
endfunction()
