// svg_check FILE: succeeds if FILE is well-formed XML whose root is an <svg> with something in it.
#include <tinyxml.h>

#include <iostream>

int main(int argc, char **argv)
{
    if (argc != 2) return 2;
    TiXmlDocument document;
    if (!document.LoadFile(argv[1])) {
        std::cerr << argv[1] << ":" << document.ErrorRow() << ": " << document.ErrorDesc() << "\n";
        return 1;
    }
    const TiXmlElement *root = document.RootElement();
    return root->ValueStr() == "svg" && root->FirstChildElement("g") != nullptr ? 0 : 1;
}
