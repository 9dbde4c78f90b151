# Writes files as arrays into one C++ source, the definitions of shell/embedded/embedded.h:
#   cmake -DOUTPUT=... -DFONTS=<folder> -DEXAMPLES=<folder> -DLANGUAGES=<folder> -DHINTS=<folder> [-DWINDOW=ON] -P embed.cmake
# WINDOW: with the gallery, the hints and the languages' tables, which the page downloads.
# Documents are *.json of the examples folder itself; figures and problems those of its folders of these
# names; the gallery holds those of the lessons, too.
set(text "// Written by shell/embedded/embed.cmake.\n#include \"shell/embedded/embedded.h\"\n\n#include <array>\n\nnamespace gaitsmith::shell {\nnamespace {\n\n")

function(append_array name file)
  file(READ "${file}" hex HEX)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${hex}")
  string(REGEX REPLACE "(................................................................................)" "\\1\n" bytes
         "${bytes}")
  set(text "${text}constexpr unsigned char ${name}[] = {\n${bytes}};\n\n" PARENT_SCOPE)
endfunction()

append_array(kInterRegular "${FONTS}/inter-regular.ttf")
append_array(kInterSemiBold "${FONTS}/inter-semibold.ttf")

# The table of hints of a language, as an expression.
function(append_hints code number)
  set(hints "{}")
  if(WINDOW)
    append_array("kHints${number}" "${HINTS}/${code}.json")
    set(text "${text}" PARENT_SCOPE)
    set(hints "{reinterpret_cast<const char*>(kHints${number}), sizeof kHints${number}}")
  endif()
  set(hints "${hints}" PARENT_SCOPE)
endfunction()

# English is the language of the sources and has no table of words.
append_hints(en English)
set(languages "    {\"en\", \"English\", {}, ${hints}},\n")
file(GLOB tables ${LANGUAGES}/*.json)
list(SORT tables)
foreach(file IN LISTS tables)
  get_filename_component(code "${file}" NAME_WE)
  file(READ "${file}" json)
  string(JSON name GET "${json}" name)
  set(table "{}")
  # Numbered, since a code such as pt-br is no identifier.
  list(FIND tables "${file}" number)
  append_hints(${code} ${number})
  if(WINDOW)
    append_array("kTable${number}" "${file}")
    set(table "{reinterpret_cast<const char*>(kTable${number}), sizeof kTable${number}}")
  endif()
  string(APPEND languages "    {\"${code}\", \"${name}\", ${table}, ${hints}},\n")
endforeach()

# JSON as raw strings, in pieces, since compilers limit the length of one.
function(append_examples table)
  file(GLOB files ${ARGN})
  list(SORT files)
  set(rows "")
  list(LENGTH files count)
  foreach(file IN LISTS files)
    get_filename_component(stem "${file}" NAME_WE)
    file(READ "${file}" json)
    string(REGEX REPLACE "\n *" "" json "${json}") # indentation
    string(REPLACE "\": " "\":" json "${json}")
    set(pieces "")
    string(LENGTH "${json}" length)
    set(at 0)
    while(at LESS length)
      string(SUBSTRING "${json}" ${at} 8000 piece)
      string(APPEND pieces "\n    R\"json(${piece})json\"")
      math(EXPR at "${at} + 8000")
    endwhile()
    string(APPEND rows "  {\"${stem}\",${pieces}},\n")
  endforeach()
  set(text "${text}constexpr std::array<Example, ${count}> ${table} = {{\n${rows}}};\n\n" PARENT_SCOPE)
endfunction()

# The page downloads the other documents when one is opened (web/share/examples.js).
if(WINDOW)
  append_examples(kDocuments "${EXAMPLES}/*.json")
else()
  append_examples(kDocuments "${EXAMPLES}/star-man-shuffle.json")
endif()
append_examples(kFigures "${EXAMPLES}/figures/*.json")
append_examples(kProblems "${EXAMPLES}/problems/*.json")
set(gallery "{}")
if(WINDOW)
  append_examples(kGallery "${EXAMPLES}/gallery/*.json" "${EXAMPLES}/lessons/*.json")
  set(gallery "kGallery")
endif()

string(APPEND text "}  // namespace\n
std::span<const unsigned char> InterRegular() { return kInterRegular; }
std::span<const unsigned char> InterSemiBold() { return kInterSemiBold; }
std::span<const Example> ExampleDocuments() { return kDocuments; }
std::span<const Example> ExampleFigures() { return kFigures; }
std::span<const Example> ExampleProblems() { return kProblems; }
std::span<const Example> ExampleGallery() { return ${gallery}; }
std::span<const Language> Languages() {
  static const auto kLanguages = std::to_array<Language>({\n${languages}  });
  return kLanguages;
}

}  // namespace gaitsmith::shell\n")
file(WRITE "${OUTPUT}" "${text}")
