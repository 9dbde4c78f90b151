// SPDX-License-Identifier: MIT
// Prints the catalogue as a JavaScript module. The page's build runs this program under Node.
#include <cstdio>

#include "shell/catalogue/catalogue.h"

int main() { return std::fputs(gaitsmith::shell::CatalogueModule().c_str(), stdout) < 0 ? 1 : 0; }
