// SPDX-License-Identifier: MIT
// STEP files read and transferred by Open CASCADE.
#include "bench/files/job.h"

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>
#include <cstdlib>

namespace {

// Every face once, as often as it may be placed.
bench::files::Answer read(const char *path, bool areas) {
    STEPControl_Reader reader;
    if (reader.ReadFile(path) != IFSelect_RetDone || reader.TransferRoots() == 0) {
        std::fprintf(stderr, "%s is not read\n", path);
        std::exit(1);
    }
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(reader.OneShape(), TopAbs_FACE, faces);
    bench::files::Answer answer;
    answer.faces = faces.Extent();
    for (int i = 1; areas && i <= faces.Extent(); ++i) {
        GProp_GProps properties;
        BRepGProp::SurfaceProperties(faces(i), properties, 1e-6);
        answer.area += properties.Mass();
    }
    return answer;
}

} // namespace

int main(int count, char **arguments) {
    Message::DefaultMessenger()->ChangePrinters().Clear(); // what it says of each file
    return bench::files::run(count, arguments, read);
}
