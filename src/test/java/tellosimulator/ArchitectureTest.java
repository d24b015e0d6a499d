package tellosimulator;

import static com.tngtech.archunit.base.DescribedPredicate.describe;
import static com.tngtech.archunit.base.DescribedPredicate.not;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.methods;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.AccessTarget;
import com.tngtech.archunit.core.domain.JavaAccess;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaMember;
import com.tngtech.archunit.core.domain.JavaModifier;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import tellosimulator.fault.FaultKind;
import tellosimulator.junit.SimulatedDrone;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.sim.Control;
import tellosimulator.testing.Jvm;
import tellosimulator.testing.NeedsTool;
import tellosimulator.testing.Tool;

/** Checks the package rules of docs/architecture.md. */
@Tag("slow")
class ArchitectureTest {

  private static final String ROOT = "tellosimulator";

  private static final String CONSTRUCTOR = "<init>";

  /** Each package and its direct foundations; their foundations are included transitively. */
  private static final Map<String, List<String>> STANDS_ON =
      Map.ofEntries(
          Map.entry("math", List.of()),
          Map.entry("words", List.of()),
          Map.entry("translation", List.of("words")),
          Map.entry("concurrent", List.of()),
          Map.entry("files", List.of("words")),
          Map.entry("json", List.of()),
          Map.entry("time", List.of()),
          Map.entry("profile", List.of("math")),
          Map.entry("extension", List.of("time")),
          Map.entry("command", List.of("controller")),
          Map.entry("world", List.of("math", "time", "words")),
          Map.entry("model", List.of("extension", "world", "profile")),
          Map.entry("physics", List.of("model")),
          Map.entry("sensor", List.of("model")),
          Map.entry("fault", List.of("sensor")),
          Map.entry("controller", List.of("physics", "fault")),
          Map.entry("protocol", List.of("command")),
          Map.entry("sim", List.of("concurrent", "protocol")),
          Map.entry("goal", List.of("sim")),
          Map.entry("network", List.of("sim")),
          Map.entry("scenery", List.of("goal")),
          Map.entry("video", List.of("files", "network", "scenery")),
          Map.entry("scenario", List.of("files", "goal", "network")),
          Map.entry("recording", List.of("scenario", "video", "json")),
          Map.entry("proxy", List.of("recording")),
          Map.entry("junit", List.of("report", "translation")),
          Map.entry("control", List.of("junit", "json")),
          Map.entry("pilot", List.of("goal")),
          Map.entry("web", List.of("control", "pilot", "recording")),
          Map.entry("headless", List.of("control", "recording", "web")),
          Map.entry("comparison", List.of("recording")),
          Map.entry("export", List.of("recording")),
          Map.entry("replay", List.of("recording")),
          Map.entry("report", List.of("comparison", "grade", "recording", "video")),
          Map.entry("launcher", List.of("concurrent", "files", "time")),
          Map.entry("grade", List.of("launcher", "replay")),
          Map.entry(
              "cli", List.of("export", "grade", "proxy", "report", "scenario", "video", "web")),
          Map.entry("jvm", List.of("concurrent", "time")),
          Map.entry("log", List.of("concurrent", "words")),
          Map.entry("view.fx", List.of("scenery")),
          Map.entry("view.settings", List.of("files")),
          Map.entry("view.text", List.of("files", "translation", "words", "view.settings")),
          Map.entry("view.video", List.of("video", "view.fx")),
          Map.entry("view.model", List.of("recording", "view.text", "view.video")),
          Map.entry("view.drone", List.of("view.fx", "view.model")),
          Map.entry("view.controls", List.of("view.drone")),
          Map.entry("view.gallery", List.of("view.model")),
          Map.entry("view.goal", List.of("view.drone")),
          Map.entry("view.log", List.of("view.model")),
          Map.entry("view.pilot", List.of("pilot", "view.controls")),
          Map.entry("view.plan", List.of("view.controls")),
          Map.entry("view.projector", List.of("view.controls")),
          Map.entry("view.replay", List.of("replay", "report", "view.layout")),
          Map.entry("view.world", List.of("view.drone")),
          Map.entry(
              "view.layout", List.of("view.controls", "view.gallery", "view.pilot", "view.world")),
          Map.entry(
              "view.app",
              List.of(
                  "view.goal", "view.log", "view.plan", "view.projector", "view.replay", "web")));

  /** Packages whose results can affect a trace. */
  private static final String[] CORE =
      packages(
          "math",
          "words",
          "time",
          "extension",
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

  /** Methods whose last bits may differ between machines; those of StrictMath do not. */
  private static final Set<String> INEXACT =
      Set.of(
          "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "exp",
          "expm1", "log", "log10", "log1p", "pow", "cbrt", "hypot");

  private static final Pattern BRITISH =
      Pattern.compile(
          "(?i)colour|centre|metre|grey|behaviour|neighbour|licence|analys(e|ing)"
              + "|(initial|normal|organ|quant|raster|real|recogn|serial|synchron)is(e|ing|ation)");

  private static final JavaClasses CLASSES = ProjectClasses.MAIN;

  private static final JavaClasses TEST_CLASSES = ProjectClasses.TESTS;

  @Test
  void everyPackageIsInTheTable() {
    Set<String> found =
        CLASSES.stream()
            .map(ArchitectureTest::rowOf)
            .filter(name -> !name.isEmpty())
            .collect(Collectors.toSet());

    assertThat(found).contains("math", "command", "controller", "sim", "network", "view.app");
    assertThat(found).isSubsetOf(STANDS_ON.keySet());
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
  void mainStandsAloneAndOnlyItImportsTheCommandLineAndTheWindow() {
    assertThat(CLASSES.stream().filter(type -> type.getPackageName().equals(ROOT)))
        .extracting(type -> type.getName().replaceAll("\\$.*", ""))
        .isSubsetOf(ROOT + ".Main", ROOT + ".package-info");
    noClasses()
        .that()
        .resideOutsideOfPackages(ROOT, inside("cli"))
        .should()
        .dependOnClassesThat()
        .resideInAnyPackage(ROOT, ROOT + ".cli..")
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
    slices().matching(ROOT + ".(**)").should().beFreeOfCycles().check(CLASSES);
  }

  @Test
  void noTwoTypesShareASimpleName() {
    Map<String, Set<String>> owners = new TreeMap<>();
    Stream.concat(CLASSES.stream(), TEST_CLASSES.stream())
        .filter(JavaClass::isTopLevelClass)
        .filter(type -> !type.getSimpleName().equals("package-info"))
        .forEach(
            type ->
                owners
                    .computeIfAbsent(type.getSimpleName(), name -> new TreeSet<>())
                    .add(type.getName()));

    assertThat(owners).hasSizeGreaterThan(500).containsKeys("Main", "ArchitectureTest");
    assertThat(owners.values()).allMatch(types -> types.size() == 1);
  }

  @Test
  void identifiersAreSpeltAsThoseOfJavaFx() {
    Set<String> british =
        Stream.concat(CLASSES.stream(), TEST_CLASSES.stream())
            .flatMap(
                type ->
                    Stream.concat(
                        Stream.of(type.getSimpleName()),
                        type.getMembers().stream().map(JavaMember::getName)))
            .filter(name -> BRITISH.matcher(name).find())
            .collect(Collectors.toSet());

    assertThat(british).isEmpty();
  }

  /**
   * Datagrams of the video are lost or late as those of other links; the table itself maps them.
   */
  @Test
  void everyKindOfFaultHasAnEffect() {
    Set<String> withoutEffect =
        CLASSES.get(FaultKind.class).getFields().stream()
            .filter(field -> field.getRawType().isEquivalentTo(FaultKind.class))
            .filter(
                field ->
                    field.getAccessesToSelf().stream()
                        .allMatch(access -> isWithin(access.getOriginOwner(), FaultKind.class)))
            .map(JavaMember::getName)
            .collect(Collectors.toSet());

    assertThat(withoutEffect)
        .containsExactlyInAnyOrder(FaultKind.VIDEO_LOSS.name(), FaultKind.VIDEO_LATE.name());
  }

  @Test
  void everyControlIsApplied() {
    Set<String> ignored =
        CLASSES.get(Control.class).getAllSubclasses().stream()
            .filter(type -> !type.isInterface())
            .filter(
                type ->
                    type.getInstanceofChecksWithTypeOfSelf().stream()
                        .map(check -> check.getOwner().getOwner())
                        .noneMatch(owner -> owner.getPackageName().equals(ROOT + ".sim")))
            .map(JavaClass::getSimpleName)
            .collect(Collectors.toSet());

    assertThat(CLASSES.get(Control.class).getAllSubclasses()).hasSizeGreaterThan(15);
    assertThat(ignored).isEmpty();
  }

  private static boolean isWithin(JavaClass type, Class<?> outer) {
    return type.getName().replaceAll("\\$.*", "").equals(outer.getName());
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
  void nobodyDrawsWithAwtAndOnlyPostersAreReadAndPicturesEncodedWithIt() {
    noClasses().should().dependOnClassesThat().resideInAPackage("java.awt").check(CLASSES);
    noClasses()
        .that()
        .doNotHaveFullyQualifiedName(ROOT + ".scenery.texture.ImageFile")
        .and()
        .doNotHaveFullyQualifiedName(ROOT + ".video.picture.JpegEncoder")
        .should()
        .dependOnClassesThat()
        .resideInAnyPackage("java.awt..", "javax.imageio..")
        .because("the JDK's readers and writers of image files have them as java.awt.image does")
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

  /** The plan tests thousands of positions for an item, on the JavaFX thread. */
  @Test
  void thePlanIndexesNoObstacles() {
    noClasses()
        .that()
        .resideInAPackage(inside("view"))
        .should()
        .dependOnClassesThat()
        .haveFullyQualifiedName(ROOT + ".world.Obstacles")
        .check(CLASSES);
  }

  @Test
  void onlyWorkersThePacerAndTheWindowKnowTheWallClockAndSleep() {
    DescribedPredicate<JavaClass> others =
        describe(
            "neither in concurrent nor in time nor in log nor in view",
            type ->
                !Set.of("concurrent", "time", "log").contains(rowOf(type)) && !ofTheWindow(type));
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
        .and()
        .doNotHaveSimpleName("MoodleFiles") // the constant date in its archive
        .should()
        .dependOnClassesThat()
        .haveNameMatching("java\\.util\\.(Date|Calendar)|java\\.time\\.(?!Duration).*")
        .check(CLASSES);
  }

  @Test
  void onlyTheActionsOfTheWindowWaitForTheSimulation() {
    noClasses()
        .that()
        .resideInAPackage(inside("view"))
        .and()
        .doNotHaveSimpleName("SimulatorActions")
        .should()
        .accessTargetWhere(
            target(
                "the simulation is waited for",
                OnlineSimulation.class,
                "carryOut",
                "letPass",
                "setCommandPort",
                "setReach"))
        .because("its worker carries out what a person does, so that the window never stands still")
        .check(CLASSES);
  }

  @Test
  void randomNumbersHaveASeed() {
    noClasses()
        .that()
        .doNotHaveFullyQualifiedName(ROOT + ".control.AccessToken")
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
        .because("flights can be repeated; only the secret of the control channel must not be")
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
  void onlyMainAndTheLogWriteToStandardStreams() {
    noClasses()
        .that()
        .resideOutsideOfPackages(ROOT, inside("log"))
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

  /**
   * {@link Tool} and {@link Jvm} check that the running test declares the programs that it needs.
   */
  @Test
  void testsStartProcessesInOnePlace() {
    Set<String> programs = Set.of("benchmark", "endurance", "fidelity");
    noClasses()
        .that(describe("of a test", type -> !programs.contains(rowOf(type))))
        .and()
        .doNotBelongToAnyOf(Tool.class, Jvm.class)
        .should()
        .accessTargetWhere(target("a process is built", ProcessBuilder.class, CONSTRUCTOR))
        .orShould()
        .accessTargetWhere(target("a process is started", Runtime.class, "exec"))
        .check(TEST_CLASSES);
    methods()
        .that(
            describe(
                "run a program beside a test",
                method ->
                    method.getMethodCallsFromSelf().stream()
                        .anyMatch(
                            call ->
                                call.getTargetOwner().isEquivalentTo(SimulatedDrone.class)
                                    && call.getName().equals("program"))))
        .should()
        .beAnnotatedWith(NeedsTool.class)
        .orShould()
        .beDeclaredInClassesThat()
        .areAnnotatedWith(Tag.class)
        .check(TEST_CLASSES);
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
        .resideOutsideOfPackage(inside("log"))
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

  /** Returns the package itself and all its foundations, transitively. */
  private static Set<String> foundation(String name) {
    Set<String> all = new LinkedHashSet<>();
    all.add(name);
    STANDS_ON.get(name).forEach(below -> all.addAll(foundation(below)));
    return all;
  }

  private static boolean ofTheWindow(JavaClass type) {
    return type.getPackageName().startsWith(ROOT + ".view.");
  }

  /** Returns the table row of a class: each package of the window has its own. */
  private static String rowOf(JavaClass type) {
    String name = type.getPackageName();
    String below = name.equals(ROOT) ? "" : name.substring(ROOT.length() + 1);
    return below.startsWith("view.") ? below : below.split("\\.", 2)[0];
  }

  private static String[] packages(String... names) {
    return Arrays.stream(names).map(ArchitectureTest::inside).toArray(String[]::new);
  }

  private static String inside(String name) {
    return ROOT + "." + name + "..";
  }
}
