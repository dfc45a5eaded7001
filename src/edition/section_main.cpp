// main() of every section's program.
#include "edition/registry.hpp"

int main(int argc, char** argv)
{
  return edition::run(argc, argv);
}
