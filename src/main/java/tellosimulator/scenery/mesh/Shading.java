package tellosimulator.scenery.mesh;

import java.util.Optional;

/** The effect of light, transparency and depth on a material. */
public enum Shading {
  /** Unlit: displayed in the colours of the texture, into which light and shade are baked. */
  UNLIT,
  /** Opaque, lit by {@link Lights#ON_DRONES}, with highlights if the renderer supports them. */
  GLOSSY(Lights.ON_DRONES),
  /** Opaque, lit by {@link Lights#ON_FURNITURE}. */
  MATTE(Lights.ON_FURNITURE),
  /** Unlit and opaque, on the coplanar surface below it. */
  PANEL,
  /** Unlit and blended onto the coplanar surface below it, using the texture's alpha. */
  DECAL,
  /** Unlit and blended using the texture's alpha; depth is tested but not written. */
  TRANSLUCENT;

  private final Optional<Lights> lights;

  Shading() {
    lights = Optional.empty();
  }

  Shading(Lights lights) {
    this.lights = Optional.of(lights);
  }

  /** Returns the lights that shine on the material, or an empty result if it is unlit. */
  public Optional<Lights> lights() {
    return lights;
  }

  /** Returns whether the material lies on a coplanar surface. */
  public boolean coplanar() {
    return this == PANEL || this == DECAL;
  }

  /** Returns whether the material is blended with the surfaces behind it. */
  public boolean blended() {
    return this == DECAL || this == TRANSLUCENT;
  }
}
