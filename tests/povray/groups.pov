// What groups.tia says, written by hand: nothing of it comes from tia.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 6 adc_bailout 0 ambient_light rgb 1 }
background { rgb <0, 0, 0.2> }
camera {
    perspective location <0.5, 3.2, 9> right -x * image_width / image_height up y
    angle 2 * degrees(atan(tan(radians(21)) * image_width / image_height)) look_at <0, 1.3, 0>
}
#default { finish { ambient 1 diffuse 0 } }
#declare LONG = 1.2;
#declare THIN = 0.15;
#declare Red = texture { pigment { rgb <0.8, 0.2, 0.1> } }
#declare Blue = texture { pigment { rgb <0.2, 0.3, 0.9> } }
#declare Green = texture { pigment { rgb <0.3, 0.8, 0.2> } }
#declare Orange = texture { pigment { rgb <0.9, 0.6, 0.1> } }
/* On the floor u is x and v is -z; the surface goes through the middle of a layer of cubes. A square more or less
 * along z swaps the colours. */
plane {
    y, 0
    pigment {
        checker rgb 0.9, rgb <0.3, 0.2, 0.5>
        scale <1.5, 1, 0.75> translate <0.4, 0.5, 0.3>
    }
}
#declare Arm = union {
    cylinder { 0, <LONG, 0, 0>, THIN texture { Blue } }
    union {
        box { <-THIN, -0.25, -0.25>, <0.5, 0.25, 0.25> texture { Orange } }
        union {
            cone { 0, 0.3, <1, 0, 0>, 0 open texture { Green } }
            sphere { <1.1, 0, 0>, 0.2 texture { Red } }
            scale <0.8, 0.5, 0.5> rotate <20, -30, 10> translate <0.5, 0.2, 0>
        }
        scale 0.7 rotate <0, 0, 35> translate <LONG, 0, 0>
    }
}
/* The picture on a side of the box, its lower left corner at (0.25, 0.125) of the side, two along each. */
#macro Side(X, Z, Turn)
    box {
        <-X, -0.6, 0>, <X, 0.8, 0.000001>
        pigment {
            image_map { ppm "quarters.ppm" gamma 1.0 }
            scale 0.5 translate <0.25, 0.125, 0> scale <2 * X, 1.4, 1> translate <-X, -0.6, 0>
        }
        translate <0, 0, Z - 0.000001> rotate Turn * y
    }
#end
union {
    union {
        Side(0.3, 0.3, 0) Side(0.3, 0.3, 90) Side(0.3, 0.3, 180) Side(0.3, 0.3, -90)
        /* Seen from above v is -z. */
        box {
            <-0.3, 0, -0.3>, <0.3, 0.000001, 0.3>
            pigment {
                image_map { ppm "quarters.ppm" gamma 1.0 }
                scale 0.5 translate <0.25, 0.125, 0> scale <0.6, 0.6, 1> translate <-0.3, -0.3, 0> rotate -90 * x
            }
            translate 0.799999 * y
        }
        rotate <0, -10, 0>
    }
    object { Arm translate <0.3, 0.6, 0> }
    object { Arm scale 0.9 rotate <0, 180, 40> translate <-0.3, 0.6, 0> }
    scale 1.5 rotate <0, 25, 0> translate <-1.6, 1, 0>
}
union {
    box { -0.5, 0.5 rotate <0, 30, 0> texture { Orange } }
    cylinder { 0, <0, 0.9, 0>, 0.2 scale <1, 1.5, 1> rotate <90, 0, 0> translate <0, 0.8, 0> texture { Green } }
    scale <0.8, 1.6, 0.8> translate <2.6, 0.8, 0.5>
}
plane { z, -6 pigment { rgb <0.5, 0.6, 0.7> } }
