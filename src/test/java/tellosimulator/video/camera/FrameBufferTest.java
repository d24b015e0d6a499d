package tellosimulator.video.camera;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import tellosimulator.video.picture.Picture;

class FrameBufferTest {

  private static final int WIDTH = 16;

  /** Number of random frames; the same in each run. */
  private static final int FRAMES = 200;

  private static final float FAR_INV_Z = 0.5f;
  private static final float NEAR_INV_Z = 1;

  private final Picture picture = new Picture(WIDTH, 4);
  private final FrameBuffer frameBuffer = FrameBuffer.on(picture, 2);

  FrameBufferTest() {
    frameBuffer.clear();
  }

  @Test
  void lumaIsWrittenForEachPixelAndChromaForEvenRowsAndColumns() {
    frameBuffer.draw(0, span(1, 5, 10), FAR_INV_Z, 0);
    frameBuffer.draw(1, span(1, 5, 20), FAR_INV_Z, 0);

    assertThat(unsigned(picture.y(), 0, 7)).containsExactly(16, 10, 11, 12, 13, 14, 16);
    assertThat(unsigned(picture.y(), WIDTH, 7)).containsExactly(16, 20, 21, 22, 23, 24, 16);
    assertThat(unsigned(picture.u(), 0, 4)).containsExactly(128, 110, 111, 128);
    assertThat(unsigned(picture.v(), 0, 4)).containsExactly(128, 210, 211, 128);
  }

  @Test
  void rowsBelowTheFrameBufferDoNotChange() {
    Arrays.fill(picture.y(), (byte) 7);

    frameBuffer.clear();
    frameBuffer.draw(1, span(0, WIDTH, 90), FAR_INV_Z, 0);

    assertThat(unsigned(picture.y(), 2 * WIDTH, 2 * WIDTH)).containsOnly(7);
  }

  @Test
  void translucentSpansAreBlendedAndDoNotWriteDepth() {
    frameBuffer.draw(0, span(0, 8, 100), FAR_INV_Z, 0);
    Span half = span(3, 3, 40);
    Arrays.fill(half.alpha, 128);
    Arrays.fill(half.chromaAlpha, 128);
    frameBuffer.blend(0, half, NEAR_INV_Z, 0, 256);

    // 40 + 103 / 2, 41 + 104 / 2, ...; the colour of column 4: 140 + 202 / 2
    assertThat(unsigned(picture.y(), 2, 5)).containsExactly(102, 91, 92, 94, 106);
    assertThat(unsigned(picture.u(), 1, 3)).containsExactly(201, 240, 203);

    frameBuffer.blend(0, half, FAR_INV_Z / 2, 0, 256);
    assertThat(unsigned(picture.y(), 2, 5)).as("behind").containsExactly(102, 91, 92, 94, 106);

    frameBuffer.draw(0, span(0, 8, 60), (FAR_INV_Z + NEAR_INV_Z) / 2, 0);
    assertThat(unsigned(picture.y(), 2, 5)).containsExactly(62, 63, 64, 65, 66);
  }

  /**
   * The depth test is limited to the covered interval, so many overlaps are tested, odd and even.
   */
  @Test
  void theNearestSpanIsSeenInAnyDrawingOrder() {
    SplittableRandom random = new SplittableRandom(7);
    for (int i = 0; i < FRAMES; i++) {
      frameBuffer.clear();
      int[] wanted = new int[WIDTH];
      float[] nearest = new float[WIDTH];
      Arrays.fill(wanted, 16);
      for (int part = 0; part < 6; part++) {
        int from = random.nextInt(WIDTH);
        int count = 1 + random.nextInt(WIDTH - from);
        float invZ = 0.1f + random.nextFloat();
        float invZdx = (random.nextFloat() - 0.5f) * 0.01f;
        frameBuffer.draw(0, span(from, count, 20 * part + 20), invZ, invZdx);
        for (int x = from; x < from + count; x++) {
          float here = invZ + invZdx * (x - from);
          if (here > nearest[x]) {
            nearest[x] = here;
            wanted[x] = 20 * part + 20 + x - from;
          }
        }
      }

      assertThat(unsigned(picture.y(), 0, WIDTH)).as("picture %d", i).containsExactly(wanted);
    }
  }

  @Test
  void chromaPassesTheSameDepthTestAsLuma() {
    SplittableRandom random = new SplittableRandom(8);
    for (int i = 0; i < FRAMES; i++) {
      frameBuffer.clear();
      for (int part = 0; part < 6; part++) {
        int from = random.nextInt(WIDTH);
        Span span = span(from, 1 + random.nextInt(WIDTH - from), 0);
        Arrays.fill(span.first, 30 + part);
        Arrays.fill(span.second, 130 + part);
        frameBuffer.draw(0, span, 0.1f + random.nextFloat(), 0);
      }
      for (int x = 0; x < WIDTH; x += 2) {
        int brightness = picture.y()[x] & 255;
        int wanted = brightness == 16 ? 128 : 100 + brightness;
        assertThat(picture.u()[x / 2] & 255).as("picture %d, column %d", i, x).isEqualTo(wanted);
      }
    }
  }

  /** Returns a span with luma a, a + 1, ..., and chroma 100 and 200 above a. */
  private static Span span(int from, int count, int a) {
    Span span = new Span();
    span.ensureCapacity(WIDTH);
    span.x = from;
    span.count = count;
    Arrays.setAll(span.first, i -> a + i);
    Arrays.setAll(span.second, i -> 100 + a + i);
    Arrays.setAll(span.third, i -> 200 + a + i);
    return span;
  }

  private static int[] unsigned(byte[] plane, int from, int count) {
    int[] numbers = new int[count];
    Arrays.setAll(numbers, i -> plane[from + i] & 255);
    return numbers;
  }
}
