package tellosimulator.video.codec;

/**
 * Chooses how finely each picture is told, so that a stream keeps to its bit rate and all pictures
 * look equally good.
 *
 * <p>It works with what a picture would take at QP 0, which changes slowly: 6 more halve the bits.
 * From what the last key picture and the last others would take follows the one QP at which all
 * pictures from a key picture to the next fit the rate; what was sent too much or too little before
 * is soon made up for. A picture that takes far more than expected, as after a cut, is told more
 * coarsely from row to row.
 */
final class RateControl {

  /**
   * Decided: nobody sees more. Measured: pictures that do not change take up to 2 kB for ever, at
   * 18 nothing, but are 2 dB better. Below 10 a level could be longer than a code may be.
   */
  private static final int LEAST_QP = 15;

  /** Decided: key pictures are finer, since those after them consist of their parts. */
  private static final int KEY_GAIN = 3;

  /** Decided: other pictures may be finer still where hardly anything changes. */
  private static final int MOST_GAIN = 14;

  /** Decided: so much may QP rise from picture to picture in one scene. */
  private static final int MOST_RISE = 2;

  /**
   * Decided: so much does it fall where it could fall by more. Measured: finest where all stands.
   */
  private static final int LEAP = 4;

  /** Decided: wishes to change QP by less are not followed. */
  private static final double DOUBT = 0.8;

  /** Decided: no QP swings from row to row, but a picture of only noise gets coarse in time. */
  private static final int ROW_CHANGE = 1;

  /** Of an average picture's bits: Decided: a third of the second that it begins. */
  private static final double KEY_LIMIT = 10;

  /** Of the bits from key picture to key picture. Decided: half is left for the others. */
  private static final double MOST_SHARE = 0.5;

  /** Of an average picture's bits. Decided: as much as the network has to carry after a cut. */
  private static final double LIMIT = 4;

  /** Share of a new figure in the mean of those before, if it is larger. Decided: soon. */
  private static final double BAD_NEWS = 0.4;

  /** Share of a new figure in the mean of those before, if it is smaller. Decided: less soon. */
  private static final double GOOD_NEWS = 0.2;

  /** The same, if it is below {@link #NOTHING} of those before. Decided: at once. */
  private static final double BEST_NEWS = 0.5;

  /** Where nothing changes any more, pictures take less than this share. Measured: by a stop. */
  private static final double NOTHING = 0.1;

  /** Decided: a picture may not count more times than expected; a cut says nothing of the next. */
  private static final double MOST_NEWS = 2;

  /** Decided: what was sent too much or too little is made up for within this time [s]. */
  private static final double REPAID_IN = 0.5;

  /** Decided: so many seconds of unused bits are kept for later. */
  private static final double MOST_SAVED = 0.25;

  /** Decided: so many seconds of bits are made up for. */
  private static final double MOST_OWED = 1;

  /** What a macroblock of a key picture takes at QP 0, about. Measured: in the default room. */
  private static final double FIRST_KEY_BITS = 6000;

  /** What others take of a key picture's bits, about. Measured: in slow flight. */
  private static final double FIRST_SHARE = 0.15;

  private final int rows;
  private double bitsPerPicture;
  private double picturesPerSecond;

  /** What pictures would take at QP 0. */
  private double keyBits;

  private double otherBits;

  /** How much more was sent than may be; negative if less. */
  private double balance;

  /** How much more than its share the last key picture took. */
  private double keyExcess;

  private int fromKeyToKey;
  private int sinceKey;
  private boolean free = true;
  private boolean key;
  private int qp = 30;
  private int otherQp = 30;
  private int keyQp = 30;
  private long qpSum;
  private double limit;

  /**
   * @param macroblocks of a picture
   * @param rows of macroblocks
   */
  RateControl(int macroblocks, int rows) {
    this.rows = rows;
    keyBits = FIRST_KEY_BITS * macroblocks;
    otherBits = FIRST_SHARE * keyBits;
    setRate(30, 2_500_000);
  }

  /**
   * From now on; what was sent before no longer counts, and the next picture may be as large as
   * ever.
   */
  void setRate(int framesPerSecond, int bitsPerSecond) {
    picturesPerSecond = framesPerSecond;
    bitsPerPicture = (double) bitsPerSecond / framesPerSecond;
    fromKeyToKey = framesPerSecond;
    sinceKey = 0;
    balance = 0;
    keyExcess = 0;
    free = true;
  }

  /** Begins a picture; the QP of its first row. */
  int begin(boolean keyPicture) {
    key = keyPicture;
    if (key) {
      fromKeyToKey = sinceKey > 0 ? sinceKey : fromKeyToKey;
      sinceKey = 0;
      keyExcess = 0;
    }
    double budget =
        Math.max(bitsPerPicture / 3, bitsPerPicture - owed() / (REPAID_IN * picturesPerSecond));
    if (key) {
      keyQp = clip(keyIdeal(budget));
      qp = keyQp;
    } else {
      double share = Math.max(bitsPerPicture / 3, budget - keyExcess / others());
      otherQp = near(Math.max(keyQp - MOST_GAIN, qpOf(otherBits, share)));
      qp = otherQp;
      free = false;
    }
    sinceKey++;
    limit = key ? keyLimit() : LIMIT * bitsPerPicture;
    qpSum = 0;
    return qp;
  }

  private double keyLimit() {
    return bitsPerPicture * Math.min(KEY_LIMIT, MOST_SHARE * fromKeyToKey);
  }

  /** How many pictures there are from a key picture to the next. */
  private double others() {
    return Math.max(1, fromKeyToKey - 1);
  }

  /** What was sent more than may be, but for what is left of the last key picture's excess. */
  private double owed() {
    return balance - keyExcess * Math.max(0, fromKeyToKey - sinceKey) / others();
  }

  /** The QP at which key picture and others fit the rate, the former finer. */
  private double keyIdeal(double budget) {
    double group = keyBits * Math.pow(2, KEY_GAIN / 6.0) + others() * otherBits;
    double ideal = qpOf(group, (1 + others()) * budget) - KEY_GAIN;
    return Math.max(ideal, qpOf(keyBits, keyLimit()));
  }

  /** Follows what is wanted with hesitation: a change that is taken back at once costs most. */
  private int near(double wanted) {
    double change = wanted - otherQp;
    if (free) {
      return clip(wanted);
    }
    if (change < -DOUBT) {
      return clip(otherQp - (change < -LEAP ? LEAP : 1));
    }
    return change > DOUBT ? clip(otherQp + Math.min(MOST_RISE, change)) : otherQp;
  }

  private static int clip(double qp) {
    return (int) Math.max(LEAST_QP, Math.min(Quality.COARSEST, Math.round(qp)));
  }

  private static double qpOf(double bits, double wanted) {
    return 6 / Math.log(2) * Math.log(bits / wanted);
  }

  /**
   * The QP of the next row.
   *
   * @param done rows that are coded
   * @param bits what these took
   */
  int row(int done, int bits) {
    qpSum += qp;
    if (bits > limit * (done + 2) / rows) {
      qp = Math.min(Quality.COARSEST, qp + ROW_CHANGE);
    }
    return qp;
  }

  /** Ends a picture; what it took. */
  void end(int bits) {
    double taken = bits * Math.pow(2, (double) qpSum / rows / 6);
    double excess = bits - bitsPerPicture;
    if (key) {
      keyBits = taken;
      keyExcess = excess;
    } else {
      learn(Math.min(taken, MOST_NEWS * otherBits));
    }
    double second = bitsPerPicture * picturesPerSecond;
    balance = Math.max(-MOST_SAVED * second, Math.min(MOST_OWED * second, balance + excess));
  }

  private void learn(double taken) {
    double share = taken < NOTHING * otherBits ? BEST_NEWS : GOOD_NEWS;
    otherBits += (taken > otherBits ? BAD_NEWS : share) * (taken - otherBits);
  }
}
