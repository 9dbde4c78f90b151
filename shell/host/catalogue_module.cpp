// SPDX-License-Identifier: MIT
// Prints the catalogue as the page's module. The page's build runs it under Node.
#include <cstdio>

#include "shell/catalogue/catalogue.h"

int main() { return std::fputs(gaitsmith::shell::CatalogueModule().c_str(), stdout) < 0 ? 1 : 0; }
