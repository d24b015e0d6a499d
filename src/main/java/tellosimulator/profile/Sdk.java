package tellosimulator.profile;

/** The versions of the drone's text protocol, oldest first. */
public enum Sdk {
  SDK_1_3("1.3"),
  SDK_2_0("2.0"),
  SDK_3_0("3.0");

  private final String version;

  Sdk(String version) {
    this.version = version;
  }

  /** Returns the version in the notation of the vendor's guides. */
  public String version() {
    return version;
  }
}
