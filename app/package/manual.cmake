# SPDX-License-Identifier: BSD-3-Clause
# What the program writes about itself, made with it and installed: man pages, completions, grammars of editors. The
# whole manual in HTML is a target of its own, contactsim_html, and installed when it was made.
set(contactsim_share ${PROJECT_BINARY_DIR}/share)
set(contactsim_manual_written ${PROJECT_BINARY_DIR}/manual_written)
add_custom_command(OUTPUT ${contactsim_manual_written}
  COMMAND contactsim manual man ${contactsim_share}/man
  COMMAND contactsim manual man-deck ${contactsim_share}/man
  COMMAND contactsim manual bash ${contactsim_share}
  COMMAND contactsim manual zsh ${contactsim_share}
  COMMAND contactsim manual fish ${contactsim_share}
  COMMAND contactsim manual vim ${contactsim_share}/vim/vimfiles
  COMMAND contactsim manual vscode ${contactsim_share}/contactsim/vscode
  COMMAND ${CMAKE_COMMAND} -E touch ${contactsim_manual_written}
  DEPENDS contactsim
  COMMENT "Writing man pages, completions and grammars")
add_custom_target(contactsim_manual ALL DEPENDS ${contactsim_manual_written})
install(DIRECTORY ${contactsim_share}/ DESTINATION ${CMAKE_INSTALL_DATADIR})

find_program(CONTACTSIM_CMARK cmark-gfm)
find_program(CONTACTSIM_SITE_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
if(CONTACTSIM_CMARK AND CONTACTSIM_SITE_PYTHON)
  add_custom_target(contactsim_html
    COMMAND ${CMAKE_COMMAND} -E rm -rf ${PROJECT_BINARY_DIR}/html
    COMMAND ${CONTACTSIM_SITE_PYTHON} ${PROJECT_SOURCE_DIR}/app/manual/make_site.py $<TARGET_FILE:contactsim>
      ${PROJECT_BINARY_DIR}/html
    DEPENDS contactsim
    COMMENT "Writing the manual in HTML")
endif()
install(DIRECTORY ${PROJECT_BINARY_DIR}/html DESTINATION ${CMAKE_INSTALL_DOCDIR} OPTIONAL)
