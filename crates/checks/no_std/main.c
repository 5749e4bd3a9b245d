#include <stdint.h>
#include <stdio.h>

int32_t double_pendulum(double angle, double dt, uint32_t steps, double angles[2]);

int main(void) {
    double angles[2];
    if (double_pendulum(-1.0471975511965976, 1e-3, 2000, angles) != 0) return 1;
    printf("%.17g %.17g\n", angles[0], angles[1]);
    return 0;
}
