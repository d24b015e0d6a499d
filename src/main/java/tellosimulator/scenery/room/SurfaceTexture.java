package tellosimulator.scenery.room;

import tellosimulator.scenery.mesh.Texture;
import tellosimulator.scenery.texture.ImageFile;

/**
 * The textures of textured rooms ({@code Walls.TEXTURED}). They are read from PNG files in the
 * program's jar, and tile without a seam.
 */
enum SurfaceTexture {
  BRICKS("bricks.png", SurfaceTexture.SIZE),
  HEXAGONS("hexagons.png", SurfaceTexture.SIZE),
  BOARDS("boards.png", SurfaceTexture.SIZE),
  TRIANGLES("triangles.png", SurfaceTexture.SIZE),
  PANELS("panels.png", SurfaceTexture.SIZE / 2),
  PARQUET("parquet.png", SurfaceTexture.SIZE);

  /**
   * Side length of the repeating square [m]. Decided: whole metres, so that it aligns with the
   * metre lines.
   */
  static final double TILE = 2;

  /** Side length of most textures [texels]. Decided: sharp from a metre away. */
  static final int SIZE = 512;

  private final Texture texture;

  SurfaceTexture(String file, int size) {
    texture = ImageFile.resource(SurfaceTexture.class, file, size);
  }

  /** Returns the texture. It is read on first use, and is always the same object. */
  Texture texture() {
    return texture;
  }
}
