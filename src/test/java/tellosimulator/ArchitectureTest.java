package tellosimulator;

import static com.tngtech.archunit.base.DescribedPredicate.describe;
import static com.tngtech.archunit.base.DescribedPredicate.not;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.AccessTarget;
import com.tngtech.archunit.core.domain.JavaAccess;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/** The rules of docs/architecture.md that hold between packages. */
class ArchitectureTest {

  private static final String ROOT = "tellosimulator";

  private static final String CONSTRUCTOR = "<init>";

  /** Each package and the packages that it stands on, and with them on all that these stand on. */
  private static final Map<String, List<String>> STANDS_ON =
      Map.ofEntries(
          Map.entry("math", List.of()),
          Map.entry("words", List.of()),
          Map.entry("concurrent", List.of()),
          Map.entry("files", List.of("words")),
          Map.entry("time", List.of()),
          Map.entry("profile", List.of("math")),
          Map.entry("command", List.of("profile", "time", "words")),
          Map.entry("world", List.of("math", "time", "words")),
          Map.entry("model", List.of("world", "profile")),
          Map.entry("physics", List.of("model")),
          Map.entry("sensor", List.of("model")),
          Map.entry("fault", List.of("model")),
          Map.entry("controller", List.of("command", "physics", "sensor")),
          Map.entry("sim", List.of("concurrent", "controller", "fault")),
          Map.entry("goal", List.of("sim")),
          Map.entry("network", List.of("sim")),
          Map.entry("scenery", List.of("sim")),
          Map.entry("video", List.of("files", "network", "scenery")),
          Map.entry("scenario", List.of("files", "goal", "network")),
          Map.entry("record", List.of("sim")),
          Map.entry("junit", List.of("scenario", "video", "record")),
          Map.entry("headless", List.of("scenario", "video", "record")));

  /** All that has a result which can reach a trace. */
  private static final String[] CORE =
      packages(
          "math",
          "words",
          "time",
          "profile",
          "command",
          "world",
          "model",
          "physics",
          "sensor",
          "fault",
          "controller",
          "sim",
          "goal");

  /** Their last bits may differ from machine to machine; those of StrictMath do not. */
  private static final Set<String> INEXACT =
      Set.of(
          "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "exp",
          "expm1", "log", "log10", "log1p", "pow", "cbrt", "hypot");

  private static final JavaClasses CLASSES =
      new ClassFileImporter()
          .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
          .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_JARS)
          .importPackages(ROOT);

  @Test
  void everyPackageIsInTheTable() {
    Set<String> found =
        CLASSES.stream()
            .map(ArchitectureTest::packageBelowRoot)
            .filter(name -> !name.isEmpty())
            .collect(Collectors.toSet());

    assertThat(found).contains("math", "command", "controller", "sim", "network", "headless");
    assertThat(found).isSubsetOf(allowed(STANDS_ON.keySet(), "view"));
  }

  @Test
  void packagesImportOnlyWhatTheyStandOn() {
    for (String name : STANDS_ON.keySet()) {
      String[] allowed = packages(foundation(name).toArray(String[]::new));
      classes()
          .that()
          .resideInAPackage(inside(name))
          .should()
          .onlyDependOnClassesThat(
              not(resideInAPackage(ROOT + "..")).or(resideInAnyPackage(allowed)))
          .allowEmptyShould(true)
          .check(CLASSES);
    }
  }

  @Test
  void nobodyImportsTheCommandLineAndOnlyItImportsTheWindow() {
    noClasses()
        .that()
        .resideOutsideOfPackage(ROOT)
        .should()
        .dependOnClassesThat()
        .resideInAPackage(ROOT)
        .check(CLASSES);
    noClasses()
        .that()
        .resideOutsideOfPackages(ROOT, inside("view"))
        .should()
        .dependOnClassesThat()
        .resideInAPackage(inside("view"))
        .check(CLASSES);
  }

  @Test
  void noTextDependsOnTheMachinesLanguage() {
    noClasses()
        .should()
        .callMethod(String.class, "formatted", Object[].class)
        .orShould()
        .callMethod(String.class, "format", String.class, Object[].class)
        .orShould()
        .callMethod(String.class, "toLowerCase")
        .orShould()
        .callMethod(String.class, "toUpperCase")
        .check(CLASSES);
  }

  @Test
  void packagesHaveNoCycles() {
    slices().matching(ROOT + ".(*)..").should().beFreeOfCycles().check(CLASSES);
  }

  @Test
  void onlyTheWindowKnowsJavaFx() {
    noClasses()
        .that()
        .resideOutsideOfPackage(inside("view"))
        .should()
        .dependOnClassesThat()
        .resideInAnyPackage("javafx..", "com.sun.javafx..", "javax.swing..")
        .check(CLASSES);
  }

  @Test
  void nobodyDrawsWithAwtAndOnlyPostersAreReadWithIt() {
    noClasses().should().dependOnClassesThat().resideInAPackage("java.awt").check(CLASSES);
    noClasses()
        .that()
        .doNotHaveFullyQualifiedName(ROOT + ".scenery.room.PictureFile")
        .should()
        .dependOnClassesThat()
        .resideInAnyPackage("java.awt..", "javax.imageio..")
        .because("the JDK's readers of image files give their images as java.awt.image has them")
        .check(CLASSES);
  }

  @Test
  void threadsAreStartedInOnePlace() {
    noClasses()
        .that()
        .resideOutsideOfPackage(inside("concurrent"))
        .should()
        .accessTargetWhere(
            target("a thread is started", Thread.class, "start", "startVirtualThread"))
        .check(CLASSES);
    noClasses()
        .that()
        .resideOutsideOfPackage(inside("concurrent"))
        .and()
        .doNotHaveFullyQualifiedName(ROOT + ".Main")
        .should()
        .accessTargetWhere(target("a thread is made", Thread.class, CONSTRUCTOR))
        .check(CLASSES);
    noClasses()
        .should()
        .dependOnClassesThat()
        .haveNameMatching(
            "java\\.util\\.(Timer|TimerTask|concurrent\\."
                + "(Executor.*|.*Executor|.*ExecutorService|ForkJoin.*|CompletableFuture))")
        .check(CLASSES);
    noClasses()
        .should()
        .accessTargetWhere(
            describe(
                "a stream goes parallel",
                call ->
                    call.getName().equals("parallel") || call.getName().equals("parallelStream")))
        .check(CLASSES);
  }

  @Test
  void onlyWorkersThePacerAndTheWindowKnowTheWallClockAndSleep() {
    DescribedPredicate<JavaClass> others =
        describe(
            "neither in concurrent nor in time nor in view",
            type -> !Set.of("concurrent", "time", "view").contains(packageBelowRoot(type)));
    noClasses()
        .that(others)
        .should()
        .accessTargetWhere(
            target("the wall clock is read", System.class, "nanoTime", "currentTimeMillis")
                .or(target("a thread sleeps", Thread.class, "sleep", "onSpinWait", "yield"))
                .or(
                    target(
                        "a thread parks",
                        java.util.concurrent.locks.LockSupport.class,
                        "park",
                        "parkNanos",
                        "parkUntil"))
                .or(target("a thread sleeps", java.util.concurrent.TimeUnit.class, "sleep"))
                .or(target("a thread waits", Object.class, "wait")))
        .check(CLASSES);
    noClasses()
        .that(others)
        .should()
        .dependOnClassesThat()
        .haveNameMatching("java\\.util\\.(Date|Calendar)|java\\.time\\.(?!Duration).*")
        .check(CLASSES);
  }

  @Test
  void randomNumbersHaveASeed() {
    noClasses()
        .should()
        .accessTargetWhere(
            describe(
                "no seed is given",
                access ->
                    access.getTarget() instanceof AccessTarget.ConstructorCallTarget maker
                        && maker.getRawParameterTypes().isEmpty()
                        && (isA(maker.getOwner(), Random.class)
                            || isA(maker.getOwner(), SplittableRandom.class))))
        .orShould()
        .accessTargetWhere(
            describe(
                "no seed is given",
                access ->
                    access.getTarget() instanceof AccessTarget.ConstructorReferenceTarget maker
                        && isA(maker.getOwner(), Random.class)))
        .orShould()
        .accessTargetWhere(
            target("no seed is given", Math.class, "random")
                .or(target("no seed is given", StrictMath.class, "random"))
                .or(target("no seed is given", java.util.UUID.class, "randomUUID"))
                .or(target("no seed is given", java.util.Collections.class, "shuffle")))
        .orShould()
        .dependOnClassesThat()
        .haveNameMatching("java\\.util\\.concurrent\\.ThreadLocalRandom|.*\\.SecureRandom")
        .check(CLASSES);
  }

  @Test
  void nothingStaticChanges() {
    fields().that().areStatic().should().beFinal().check(CLASSES);
    fields()
        .that()
        .areStatic()
        .should()
        .notHaveRawType(
            describe(
                "atomic or thread-local",
                type ->
                    type.getPackageName().equals("java.util.concurrent.atomic")
                        || isA(type, ThreadLocal.class)))
        .check(CLASSES);
    fields()
        .that()
        .areStatic()
        .and()
        .areNotPrivate()
        .and()
        .doNotHaveModifier(JavaModifier.SYNTHETIC)
        .should()
        .notHaveRawType(describe("an array", JavaClass::isArray))
        .check(CLASSES);
  }

  @Test
  void onlyTheCommandLineWritesToStandardOutput() {
    noClasses()
        .that()
        .resideOutsideOfPackage(ROOT)
        .should()
        .accessTargetWhere(
            describe(
                "a standard stream is used",
                access ->
                    isA(access.getTargetOwner(), System.class)
                        && Set.of("out", "err", "in", "setOut", "setErr")
                            .contains(access.getName())))
        .check(CLASSES);
    noClasses()
        .should()
        .accessTargetWhere(
            describe("a stack trace is printed", call -> call.getName().equals("printStackTrace")))
        .check(CLASSES);
  }

  @Test
  void flightsAndFilmsAreCalculatedTheSameOnEveryMachine() {
    noClasses()
        .that()
        .resideInAnyPackage(CORE)
        .or()
        .resideInAnyPackage(packages("scenery", "video"))
        .should()
        .accessTargetWhere(
            describe(
                "a function of Math is inexact",
                call -> isA(call.getTargetOwner(), Math.class) && INEXACT.contains(call.getName())))
        .check(CLASSES);
  }

  @Test
  void theCoreKnowsNeitherSocketsNorFiles() {
    noClasses()
        .that()
        .resideInAnyPackage(CORE)
        .should()
        .dependOnClassesThat(
            resideInAnyPackage("java.io..", "java.nio.file..", "java.nio.channels..")
                .or(
                    describe(
                        "a socket",
                        type ->
                            type.getPackageName().equals("java.net")
                                && type.getSimpleName().contains("Socket")
                                && !type.getSimpleName().equals("InetSocketAddress"))))
        .check(CLASSES);
  }

  @Test
  void theLogGoesThroughSlf4j() {
    noClasses()
        .should()
        .dependOnClassesThat()
        .resideInAnyPackage("java.util.logging..", "java.lang.System$Logger")
        .check(CLASSES);
    noClasses()
        .that()
        .resideOutsideOfPackage(ROOT)
        .should()
        .dependOnClassesThat()
        .resideInAPackage("ch.qos.logback..")
        .check(CLASSES);
  }

  private static DescribedPredicate<JavaAccess<?>> target(
      String description, Class<?> owner, String... names) {
    Set<String> wanted = Set.of(names);
    return describe(
        description,
        access -> isA(access.getTargetOwner(), owner) && wanted.contains(access.getName()));
  }

  private static boolean isA(JavaClass type, Class<?> wanted) {
    return type.isAssignableTo(wanted);
  }

  private static Set<String> allowed(Set<String> names, String another) {
    Set<String> all = new LinkedHashSet<>(names);
    all.add(another);
    return all;
  }

  /** The package itself, what it stands on, and all that these stand on. */
  private static Set<String> foundation(String name) {
    Set<String> all = new LinkedHashSet<>();
    all.add(name);
    STANDS_ON.get(name).forEach(below -> all.addAll(foundation(below)));
    return all;
  }

  private static String packageBelowRoot(JavaClass type) {
    String name = type.getPackageName();
    return name.equals(ROOT) ? "" : name.substring(ROOT.length() + 1).split("\\.", 2)[0];
  }

  private static String[] packages(String... names) {
    return Arrays.stream(names).map(ArchitectureTest::inside).toArray(String[]::new);
  }

  private static String inside(String name) {
    return ROOT + "." + name + "..";
  }
}
