package tellosimulator.world;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import tellosimulator.math.Vec3;
import tellosimulator.world.Shape.Beam;

/** The outlines of shapes, and the parts of gates, which collisions and rendering share. */
class ShapeTest {

  /** An opening of 1 by 0.5 m whose middle is at 1 m: from 0.75 to 1.25 m. */
  @Test
  void aFrameStandsOnItsSidesAndHasASill() {
    Shape.Frame frame = new Shape.Frame(1, 0.5, 0.25, 1);

    Vec3 side = new Vec3(0.25, 0.25, 1.5);
    Vec3 crossbar = new Vec3(0.25, 1, 0.25);
    assertThat(frame.beams())
        .containsExactly(
            new Beam(new Vec3(0, 0.625, 0), side),
            new Beam(new Vec3(0, -0.625, 0), side),
            new Beam(new Vec3(0, 0, 1.25), crossbar),
            new Beam(new Vec3(0, 0, 0.5), crossbar));
    assertThat(frame.post()).isEqualTo(0.5);
  }

  @Test
  void aFrameWhoseOpeningReachesTheFloorHasNoSill() {
    Shape.Frame door = new Shape.Frame(1, 2, 0.25, 1);

    assertThat(door.beams()).hasSize(3);
    assertThat(door.post()).isZero();
  }

  @Test
  void aRingHasAPostUpToItsLowestPoint() {
    assertThat(new Shape.Ring(0.5, 0.25, 1).post()).isEqualTo(0.25);
    assertThat(new Shape.Ring(0.5, 0.25, 0.75).post()).isZero();
  }

  @Test
  void onlyACylinderIsRoundFromAbove() {
    assertThat(new Shape.Cylinder(0.3, 1).round()).isTrue();
    assertThat(new Shape.Box(0.6, 0.6, 1).round()).isFalse();
    assertThat(new Shape.Ring(0.5, 0.1, 1).round()).isFalse();
    assertThat(new Shape.Frame(1, 0.5, 0.25, 1).round()).isFalse();
  }

  @Test
  void theSizeIncludesTheFrameAroundAnOpening() {
    assertThat(new Shape.Ring(0.5, 0.25, 1).size()).isEqualTo(new Vec3(0.25, 1.5, 1.75));
    assertThat(new Shape.Frame(1, 0.5, 0.25, 1).size()).isEqualTo(new Vec3(0.25, 1.5, 1.5));
  }
}
