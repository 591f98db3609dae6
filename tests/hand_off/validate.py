# SPDX-License-Identifier: MIT
"""validate.py FILE …: what OpenUSD's own validators and MaterialX's find wrong in .usda, .usdz and .mtlx files; nothing may
be."""
import sys


def wrong_in_usd(name):
    from pxr import Usd, UsdValidation
    validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    assert len(validators) > 10, "OpenUSD's validators were not found"
    stage = Usd.Stage.Open(name)
    return [error.GetErrorAsString() for error in UsdValidation.ValidationContext(validators).Validate(stage)]


def wrong_in_materialx(name):
    import MaterialX as mx
    library, document = mx.createDocument(), mx.createDocument()
    mx.loadLibraries(mx.getDefaultDataLibraryFolders(), mx.getDefaultDataSearchPath(), library)
    mx.readFromXmlFile(document, name)
    document.setDataLibrary(library)
    sound, message = document.validate()
    return [] if sound else [message]


if __name__ == "__main__":
    for name in sys.argv[1:]:
        wrong = wrong_in_materialx(name) if name.endswith(".mtlx") else wrong_in_usd(name)
        if wrong:
            sys.exit("\n".join([f"{name}:"] + wrong))
        print(f"{name}: nothing found")
