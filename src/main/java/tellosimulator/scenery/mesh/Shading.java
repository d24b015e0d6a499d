package tellosimulator.scenery.mesh;

import java.util.Optional;

/** How light, transparency and depth act on a material. */
public enum Shading {
  /** As bright as its texture, into which light and shade are painted. */
  UNLIT,
  /** Opaque, lit by {@link Lights#ON_DRONES}, with highlights where the renderer has them. */
  GLOSSY(Lights.ON_DRONES),
  /** Opaque, lit by {@link Lights#ON_FURNITURE}. */
  MATTE(Lights.ON_FURNITURE),
  /** Unlit and blended onto the surface that it coincides with, by its texture's alpha. */
  DECAL,
  /** Unlit and blended by its texture's alpha; depth tested, but never written to depth. */
  TRANSLUCENT;

  private final Optional<Lights> lights;

  Shading() {
    lights = Optional.empty();
  }

  Shading(Lights lights) {
    this.lights = Optional.of(lights);
  }

  /** The lights that shine on it; empty if it is unlit. */
  public Optional<Lights> lights() {
    return lights;
  }

  /** Whether it is blended with what is behind it. */
  public boolean blended() {
    return this == DECAL || this == TRANSLUCENT;
  }
}
