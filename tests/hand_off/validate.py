# SPDX-License-Identifier: MIT
"""validate.py FILE …: what OpenUSD's own validators and MaterialX's find wrong in .usda, .usdz and .mtlx files; nothing may
be."""
import re
import sys


def materialx_library():
    import MaterialX as mx
    library = mx.createDocument()
    mx.loadLibraries(mx.getDefaultDataLibraryFolders(), mx.getDefaultDataSearchPath(), library)
    return library


def wrong_in_usd(name):
    from pxr import Usd, UsdValidation
    validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    assert len(validators) > 10, "OpenUSD's validators were not found"
    stage = Usd.Stage.Open(name)
    wrong = [error.GetErrorAsString() for error in UsdValidation.ValidationContext(validators).Validate(stage)]
    # PyPI's OpenUSD comes without MaterialX's nodes: MaterialX itself tells whether there is such a node
    unknown = re.compile(r"MissingShaderIdInRegistry\) shaderId '(ND_\w+)'")
    known = materialx_library()
    return [text for text in wrong
            if not ((found := unknown.search(text)) and known.getNodeDef(found[1]))]


def wrong_in_materialx(name):
    import MaterialX as mx
    document = mx.createDocument()
    mx.readFromXmlFile(document, name)
    document.setDataLibrary(materialx_library())
    sound, message = document.validate()
    return [] if sound else [message]


if __name__ == "__main__":
    for name in sys.argv[1:]:
        wrong = wrong_in_materialx(name) if name.endswith(".mtlx") else wrong_in_usd(name)
        if wrong:
            sys.exit("\n".join([f"{name}:"] + wrong))
        print(f"{name}: nothing found")
