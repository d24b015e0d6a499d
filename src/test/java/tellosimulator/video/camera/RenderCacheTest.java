package tellosimulator.video.camera;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.Part;
import tellosimulator.video.camera.TestScenes.Quad;

class RenderCacheTest {

  private static final int GARBAGE_COLLECTIONS = 20;

  private final RenderCache cache = new RenderCache(ColorSpace.YUV);

  @Test
  void entriesAreReused() {
    Part part = part();

    assertThat(cache.texture(part)).isSameAs(cache.texture(part));
    assertThat(cache.mesh(part)).isSameAs(cache.mesh(part));
    assertThat(cache.textures()).isEqualTo(1);
  }

  @Test
  void entriesOfUnreachableTexturesAreDropped() {
    for (int i = 0; i < 50; i++) {
      cache.texture(part());
    }

    for (int i = 0; i < GARBAGE_COLLECTIONS && cache.textures() > 0; i++) {
      System.gc();
    }

    assertThat(cache.textures()).isZero();
  }

  private static Part part() {
    return TestScenes.painted(TestScenes.noise(16, 1), Quad.ahead(1, Vec3.ZERO, 1)).part();
  }
}
