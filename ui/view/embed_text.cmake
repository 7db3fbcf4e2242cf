# Writes a text file as a string constant: hanei::NAME.
file(READ ${TEXT} text)
file(WRITE ${OUTPUT} "#pragma once\n\nnamespace hanei {\ninline constexpr const char* ${NAME} = R\"text(${text})text\";\n}  // namespace hanei\n")
