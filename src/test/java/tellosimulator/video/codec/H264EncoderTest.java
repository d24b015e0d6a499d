package tellosimulator.video.codec;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.assertj.core.data.Percentage;
import org.jcodec.common.model.Rect;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import tellosimulator.video.picture.Picture;

class H264EncoderTest {

  private static final int FRAMES = 8;

  private static final List<TestSequence> SEQUENCES = List.of(TestSequence.values());

  private final TestPattern pattern = new TestPattern(1);

  @ParameterizedTest
  @MethodSource("sequencesAndSizes")
  void decodedFramesEqualTheReconstruction(TestSequence sequence, int width, int height) {
    H264Encoder encoder = new H264Encoder(width, height);
    JcodecDecoder decoder = new JcodecDecoder();
    Picture picture = new Picture(width, height);
    for (int i = 0; i < FRAMES; i++) {
      sequence.fill(pattern, picture, i);
      decoder.decode(encoder.encode(picture, i == 5));
      assertThat(decoder.differences(encoder.reconstruction())).as("frame %d", i).isZero();
    }
  }

  /**
   * All sequences at sizes that are and are not whole macroblocks, some at the drone's own size.
   */
  static Stream<Arguments> sequencesAndSizes() {
    Stream<Arguments> small =
        SEQUENCES.stream()
            .flatMap(
                sequence ->
                    Stream.of(Arguments.of(sequence, 648, 478), Arguments.of(sequence, 320, 720)));
    Stream<Arguments> whole =
        Stream.of(TestSequence.SLOW, TestSequence.FAST, TestSequence.CUT)
            .map(sequence -> Arguments.of(sequence, 960, 720));
    return Stream.concat(small, whole);
  }

  @ParameterizedTest
  @CsvSource({"20000", "200000", "20000000", "500000000"})
  void decodedFramesEqualTheReconstructionAtAnyRate(int bitsPerSecond) {
    H264Encoder encoder = new H264Encoder(160, 112);
    encoder.setRate(30, bitsPerSecond);
    JcodecDecoder decoder = new JcodecDecoder();
    Picture picture = new Picture(160, 112);
    for (int i = 0; i < 60; i++) {
      SEQUENCES.get(i / 15).fill(pattern, picture, i);
      decoder.decode(encoder.encode(picture, i % 20 == 0));
      assertThat(decoder.differences(encoder.reconstruction())).as("frame %d", i).isZero();
    }
  }

  @Test
  void decodedFramesEqualTheReconstructionForRandomSizesRatesAndSequences() {
    Random random = new Random(7);
    for (int round = 0; round < 20; round++) {
      int width = 16 + 2 * random.nextInt(80);
      int height = 16 + 2 * random.nextInt(80);
      H264Encoder encoder = new H264Encoder(width, height);
      JcodecDecoder decoder = new JcodecDecoder();
      Picture picture = new Picture(width, height);
      for (int i = 0; i < 20; i++) {
        encoder.setRate(1 + random.nextInt(30), 10_000 + random.nextInt(5_000_000));
        SEQUENCES.get(random.nextInt(SEQUENCES.size())).fill(pattern, picture, random.nextInt(30));
        decoder.decode(encoder.encode(picture, random.nextInt(10) == 0));
        assertThat(decoder.differences(encoder.reconstruction()))
            .as("frame %d of round %d, %d by %d", i, round, width, height)
            .isZero();
      }
    }
  }

  @Test
  void paddingToWholeMacroblocksIsCropped() {
    H264Encoder encoder = new H264Encoder(648, 478);
    JcodecDecoder decoder = new JcodecDecoder();

    decoder.decode(encoder.encode(new Picture(648, 478), true));

    Rect shown = decoder.shown();
    assertThat(List.of(shown.getX(), shown.getY(), shown.getWidth(), shown.getHeight()))
        .containsExactly(0, 0, 648, 478);
  }

  @Test
  void theFirstFrameIsIdrEvenIfNotForced() {
    AccessUnit encoded = new H264Encoder(64, 48).encode(new Picture(64, 48), false);

    assertThat(encoded.idr()).isTrue();
    assertThat(nalUnitTypes(encoded)).containsExactly(7, 8, 5);
  }

  @Test
  void spsAndPpsComeBeforeEachIdrSliceAndNowhereElse() {
    H264Encoder encoder = new H264Encoder(64, 48);
    List<List<Integer>> types = new ArrayList<>();
    for (int i = 0; i < 4; i++) {
      types.add(nalUnitTypes(encoder.encode(new Picture(64, 48), i % 2 == 0)));
    }

    // Documented: H.264, table 7-1: 7 SPS, 8 PPS, 5 IDR slice, 1 non-IDR slice.
    assertThat(types).containsExactly(List.of(7, 8, 5), List.of(1), List.of(7, 8, 5), List.of(1));
  }

  @ParameterizedTest
  @EnumSource
  void startCodesAreAtNalUnitStartsAndNowhereElse(TestSequence sequence) {
    H264Encoder encoder = new H264Encoder(320, 240);
    Picture picture = new Picture(320, 240);
    for (int i = 0; i < FRAMES; i++) {
      sequence.fill(pattern, picture, i);
      AccessUnit encoded = encoder.encode(picture, false);
      List<Integer> expected = new ArrayList<>();
      for (int nalUnit = 0; nalUnit < encoded.nalUnits(); nalUnit++) {
        expected.add(encoded.start(nalUnit));
      }
      assertThat(startCodes(encoded)).isEqualTo(expected);
      assertThat(encoded.start(encoded.nalUnits())).isEqualTo(encoded.size());
    }
  }

  /** Returns offsets of byte sequences that a decoder would interpret as a start code. */
  private static List<Integer> startCodes(AccessUnit accessUnit) {
    byte[] bytes = accessUnit.bytes();
    List<Integer> starts = new ArrayList<>();
    for (int i = 0; i + 2 < accessUnit.size(); i++) {
      if (bytes[i] == 0 && bytes[i + 1] == 0 && bytes[i + 2] >= 0 && bytes[i + 2] <= 2) {
        starts.add(i);
        assertThat(bytes[i + 2]).as("third byte of a start code").isZero();
        assertThat(bytes[i + 3]).as("fourth byte of a start code").isEqualTo((byte) 1);
        i += 3;
      }
    }
    return starts;
  }

  private static List<Integer> nalUnitTypes(AccessUnit accessUnit) {
    List<Integer> types = new ArrayList<>();
    for (int nalUnit = 0; nalUnit < accessUnit.nalUnits(); nalUnit++) {
      types.add(accessUnit.bytes()[accessUnit.start(nalUnit) + 4] & 0x1f);
    }
    return types;
  }

  @Test
  void aStillSceneTakesHardlyAnyBits() {
    H264Encoder encoder = new H264Encoder(960, 720);
    Picture picture = new Picture(960, 720);
    TestSequence.STILL.fill(pattern, picture, 0);
    int idrSize = encoder.encode(picture, true).size();
    int size = idrSize;
    for (int i = 0; i < 60; i++) {
      size = encoder.encode(picture, false).size();
    }

    assertThat(size).isLessThan(idrSize / 25);
  }

  @ParameterizedTest
  @CsvSource({"30, 1000000", "30, 2500000", "30, 5000000", "15, 2500000", "5, 1000000"})
  void theBitRateIsKept(int framesPerSecond, int bitsPerSecond) {
    H264Encoder encoder = new H264Encoder(640, 480);
    encoder.setRate(framesPerSecond, bitsPerSecond);
    Picture picture = new Picture(640, 480);
    long bits = 0;
    for (int i = 0; i < 3 * framesPerSecond; i++) {
      pattern.textured(picture, 5 * i, 3 * i);
      bits += 8L * encoder.encode(picture, i % framesPerSecond == 0).size();
    }

    assertThat(bits / 3.0).isCloseTo(bitsPerSecond, Percentage.withPercentage(15));
  }

  @Test
  void nothingIsAllocatedPerFrameAfterTheFirstOnes() {
    H264Encoder encoder = new H264Encoder(320, 240);
    List<Picture> pictures = new ArrayList<>();
    for (int i = 0; i < 30; i++) {
      Picture picture = new Picture(320, 240);
      SEQUENCES.get(i % SEQUENCES.size()).fill(pattern, picture, i);
      pictures.add(picture);
    }
    ThreadMXBean thread = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    encodeAll(encoder, pictures);
    encodeAll(encoder, pictures);
    long before = thread.getCurrentThreadAllocatedBytes();
    encodeAll(encoder, pictures);
    long taken = thread.getCurrentThreadAllocatedBytes() - before;

    // 96 of these bytes are allocated by StrictMath.pow, once a frame, in the rate control
    assertThat(taken / pictures.size()).as("bytes a frame").isLessThan(160);
  }

  private static void encodeAll(H264Encoder encoder, List<Picture> pictures) {
    for (int i = 0; i < pictures.size(); i++) {
      encoder.encode(pictures.get(i), i % 10 == 0);
    }
  }

  @Test
  void aPictureOfAnotherSizeIsRefused() {
    H264Encoder encoder = new H264Encoder(960, 720);

    assertThatIllegalArgumentException()
        .isThrownBy(() -> encoder.encode(new Picture(320, 240), false))
        .withMessage("picture is 320 by 240, but the encoder's are 960 by 720");
  }
}
