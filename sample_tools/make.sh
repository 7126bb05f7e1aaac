#!/bin/sh
# Makes every STL file of this folder from its OpenSCAD source (binary STL, mm; openscad 2021 or newer) and every STEP
# file from make_step.cpp (OpenCASCADE 7.6).
set -eu
cd "$(dirname "$0")"

# make_part SOURCE OUTPUT [OPENSCAD OPTIONS]
make_part() {
  source=$1
  output=$2
  shift 2
  openscad --quiet --export-format binstl -o "$output" "$@" "$source"
}

make_part shoe/shoe.scad shoe/shoe.stl -D height=37
make_part shoe/shoe.scad shoe/shoe_tall.stl -D height=46

for ring in narrow_ring circular_cavity; do
  for d in 0.47 0.94 1.88; do
    make_part $ring/$ring.scad $ring/die_d$d.stl -D 'part="die"' -D d=$d
    make_part $ring/$ring.scad $ring/punch_d$d.stl -D 'part="punch"' -D d=$d
  done
done
for ring in stepped_ring wide_ring; do
  make_part $ring/$ring.scad $ring/die.stl -D 'part="die"'
  make_part $ring/$ring.scad $ring/punch.stl -D 'part="punch"'
done
for ring in narrow_ring circular_cavity stepped_ring wide_ring; do
  make_part $ring/$ring.scad $ring/core_rod.stl -D 'part="core_rod"'
  make_part $ring/$ring.scad $ring/shoe.stl -D 'part="shoe"'
done
make_part stepped_ring/stepped_ring.scad stepped_ring/punch_long.stl -D 'part="punch_long"'
make_part narrow_ring/narrow_ring.scad narrow_ring/die_d2.35.stl -D 'part="die"' -D d=2.35
make_part narrow_ring/narrow_ring.scad narrow_ring/punch_d2.35.stl -D 'part="punch"' -D d=2.35
make_part narrow_ring/narrow_ring.scad narrow_ring/shoe_low.stl -D 'part="shoe"' -D shoe_height=24

for part in die punch shoe; do
  make_part rectangular_die/rectangular_die.scad rectangular_die/$part.stl -D "part=\"$part\""
done
for slit in 6 10 8.63 12.63; do
  make_part slit_plate/slit_plate.scad slit_plate/slit_${slit}mm.stl -D slit=$slit
done
make_part slit_plate/slit_plate.scad slit_plate/shoe_walls.stl -D 'part="shoe"'
make_part slit_plate/slit_plate.scad slit_plate/shoe_walls_45mm.stl -D 'part="shoe"' -D shoe_x=45

for part in block floor side_wall slider; do
  make_part tradeoff/tradeoff.scad tradeoff/$part.stl -D "part=\"$part\""
done

for part in half_platen floor side_wall slider gate wide_floor heap_plate lid mixer_vessel mixer_impeller; do
  make_part laboratory/laboratory.scad laboratory/$part.stl -D "part=\"$part\""
done
for half in "" _half; do
  scale=1; if [ -n "$half" ]; then scale=0.5; fi
  make_part laboratory/laboratory.scad laboratory/cup$half.stl -D 'part="cup"' -D scale_of=$scale
  for orifice in 5 7.5; do
    make_part laboratory/laboratory.scad laboratory/funnel$half\_${orifice}mm.stl -D 'part="funnel"' -D orifice=$orifice \
      -D scale_of=$scale
  done
done

for bore in 10 16; do
  vanes=8; if [ $bore = 16 ]; then vanes=12; fi
  for part in shear_cell shear_head disc; do
    make_part laboratory/laboratory.scad laboratory/${part}_$bore.stl -D "part=\"$part\"" -D bore=$bore -D vanes=$vanes
  done
done

for orifice in 30 20; do
  make_part laboratory/dosta/dosta.scad laboratory/dosta/silo_$orifice.stl -D 'part="silo"' -D orifice=$orifice
done
for part in gate box ball drum; do
  make_part laboratory/dosta/dosta.scad laboratory/dosta/$part.stl -D "part=\"$part\""
done

for part in die core_rods punch shoe; do
  make_part gear/gear.scad gear/$part.stl -D "part=\"$part\""
done

for part in die punch_low punch_high shoe; do
  make_part stepped_part/stepped_part.scad stepped_part/$part.stl -D "part=\"$part\""
done

# make_small_die NAME SHAPE WIDTH PARTS
make_small_die() {
  for part in $4; do
    make_part small_dies/small_dies.scad "small_dies/$1_$part.stl" -D "shape=\"$2\"" -D "width=$3" -D "part=\"$part\""
  done
}
make_small_die square square 8 "die punch shoe"
make_small_die slot slot 8 "die punch shoe"
make_small_die pair pair 8 "die punch shoe"
make_small_die ring_6mm ring 6 "die punch shoe core_rod"
make_small_die ring_8mm ring 8 "die punch shoe core_rod"
make_small_die gear gear 8 "die punch shoe core_rod"

# STEP files with curved faces, made with OpenCASCADE; their dates are taken out so that they come out the same.
if [ -d /usr/include/opencascade ]; then
  program=$(mktemp)
  c++ -std=c++20 -O1 -isystem /usr/include/opencascade make_step.cpp -o "$program" -lTKXDESTEP -lTKXDEIGES -lTKXCAF \
    -lTKSTEP -lTKIGES -lTKXSBase -lTKLCAF -lTKCDF -lTKOffset -lTKBool -lTKBO -lTKPrim -lTKGeomAlgo -lTKTopAlgo -lTKGeomBase -lTKBRep \
    -lTKG3d -lTKMath -lTKernel
  "$program" >/dev/null
  rm "$program"
  sed -i "s/'[0-9-]*T[0-9:]*'/'2000-01-01T00:00:00'/" ./*/*.step
  sed -i "s/15H[0-9]*\.[0-9]*/15H20000101.000000/g" ./*/*.igs
fi
