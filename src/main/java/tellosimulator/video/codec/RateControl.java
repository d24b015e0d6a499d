package tellosimulator.video.codec;

/** Thin for now. */
final class RateControl {
  private double bitsPerPicture = 2_500_000 / 30.0;
  private double qp = 30;

  void setRate(int framesPerSecond, int bitsPerSecond) {
    bitsPerPicture = (double) bitsPerSecond / framesPerSecond;
  }

  int begin(boolean key) {
    return (int) Math.round(qp) - (key ? 2 : 0);
  }

  void end(boolean key, int bits) {
    double target = bitsPerPicture * (key ? 5 : 0.85);
    qp += Math.max(-1, Math.min(1, 2 * Math.log(bits / target)));
    qp = Math.max(16, Math.min(48, qp));
  }
}
