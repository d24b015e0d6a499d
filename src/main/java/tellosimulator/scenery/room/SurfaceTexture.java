package tellosimulator.scenery.room;

import tellosimulator.scenery.mesh.Texture;
import tellosimulator.scenery.texture.PngResource;

/**
 * The textures of floor, walls and ceiling: PNG files that tile without a seam and come with the
 * program.
 */
enum SurfaceTexture {
  BRICKS("bricks.png", SurfaceTexture.SIZE),
  HEXAGONS("hexagons.png", SurfaceTexture.SIZE),
  BOARDS("boards.png", SurfaceTexture.SIZE),
  TRIANGLES("triangles.png", SurfaceTexture.SIZE),
  PANELS("panels.png", SurfaceTexture.SIZE / 2),
  PARQUET("parquet.png", SurfaceTexture.SIZE);

  /** Edge of the square that repeats [m]. Decided: whole metres, so that it meets metre lines. */
  static final double TILE = 2;

  /** Edge of most of them [texels]. Decided: sharp from a metre away. */
  static final int SIZE = 512;

  private final Texture texture;

  SurfaceTexture(String file, int size) {
    texture = PngResource.texture(SurfaceTexture.class, file, size);
  }

  /** Always the same; read when it is first used. */
  Texture texture() {
    return texture;
  }
}
