# source_of_debian(<variable> <pattern>): the folder of a source that scripts/debian_source.sh has fetched.
function(source_of_debian variable pattern)
  file(GLOB folder LIST_DIRECTORIES ON ${LGS_WEB_SOURCES}/${pattern})
  if(NOT IS_DIRECTORY "${folder}")
    message(FATAL_ERROR "There is no single folder ${LGS_WEB_SOURCES}/${pattern}. To get it:\n"
      "  scripts/web_setup.sh")
  endif()
  set(${variable} ${folder} PARENT_SCOPE)
endfunction()
