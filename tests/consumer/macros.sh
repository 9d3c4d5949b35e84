#!/bin/sh
# Macros of a firmware's other headers do not break the kernel's headers: macros.sh COMPILER PROJECT
# The kernel is compiled after each name below has been defined as a stray character. It is also compiled after every
# header of newlib and X11's own where they are installed.
. "$(dirname "$0")/../folder.sh"
compiler=$1 project=$2
needs "$compiler"
cd "$project/kernel/include"
headers=$(find impact -name '*.hpp' | LC_ALL=C sort)
include_kernel() { echo "$headers" | sed 's|.*|#include <&>|'; }

# Some header defines any single letter, with or without a digit: E is the enable line of LCDs, B1 a binary number of
# Arduino, C1 a capacitor. Those of ctype are newlib's.
letters=$(for letter in A B C D E F G H I J K L M N O P Q R S T U V W X Y Z; do
  echo "$letter"
  for digit in 0 1 2 3; do echo "$letter$digit"; done
done)
ctype='_U _L _N _S _P _C _X _B'
c='unix linux errno stdin stdout stderr assert major minor complex imaginary I isnan(x) isinf(x) isfinite(x) signbit(x) NAN INFINITY
  HUGE_VAL M_PI M_E EOF BUFSIZ RAND_MAX CHAR_BIT putc(x,y) getc(x) DOMAIN OVERFLOW UNDERFLOW SING PLOSS TLOSS'
arduino='PI HALF_PI TWO_PI DEG_TO_RAD RAD_TO_DEG EULER HIGH LOW INPUT OUTPUT INPUT_PULLUP SERIAL DISPLAY LSBFIRST MSBFIRST CHANGE
  FALLING RISING DEFAULT EXTERNAL INTERNAL DEC HEX OCT BIN F(x) min(a,b) max(a,b) abs(x) round(x) sq(x) radians(x) degrees(x)
  constrain(x,a,b) interrupts() noInterrupts() lowByte(x) highByte(x) bitRead(x,n) bitSet(x,n) bitClear(x,n) bit(n) word(x)
  digitalPinToPort(p) analogInPinToBit(p) _BV(x) isdigit(x) Serial Wire SPI PIN_A0 A4 A5 D4 D5 SS SDA SCL LED_BUILTIN'
cmsis='__I __O __IO __IM __OM __IOM __ASM __INLINE __STATIC_INLINE __NVIC_PRIO_BITS __FPU_PRESENT SCB NVIC SysTick ITM DWT MPU FPU TPI
  SCnSCB CoreDebug'
st='SET RESET ENABLE DISABLE SUCCESS ERROR UNUSED(x) SET_BIT(r,b) CLEAR_BIT(r,b) READ_BIT(r,b) READ_REG(r) WRITE_REG(r,v) POSITION_VAL(v)
  IS_TIM_INSTANCE(x) TIM1 TIM2 ADC1 DAC DAC1 DMA1 USART1 USART2 SPI1 I2C1 CAN CRC RNG RTC PWR RCC FLASH GPIOA EXTI SYSCFG CR CS1 DR SR
  HAL_MAX_DELAY LSE HSE HSI'
x11='None Bool Status True False Success Always Above Below Unsorted Complex Convex Nonconvex Opposite Absolute Relative Button1 Control
  CurrentTime Expose FocusIn FocusOut GrayScale KeyPress KeyRelease Mod1Mask ParentRelative PseudoColor StaticGravity Union'
others='BIT(n) MIN(a,b) MAX(a,b) CLAMP(x,a,b) ARRAY_SIZE(x) CONTAINER_OF(p,t,f) min max near far small interface IN OUT OPTIONAL CONST VOID
  STRICT ERROR interrupt likely(x) unlikely(x) TRUE FALSE NULL_PTR PACKED ALIGNED WEAK configASSERT(x) pdTRUE pdFALSE taskYIELD() EPS
  check(x) index move(y,x) EPSILON GRAVITY G_FORCE SCALE OFFSET STEP STATE VALUE FAULT LIMIT'
{
  echo '#include <stdint.h>
#include <stddef.h>
#include <float.h>
#include <limits.h>'
  for name in $letters $ctype $c $arduino $cmsis $st $x11 $others; do
    printf '#undef %s\n#define %s @\n' "${name%%(*}" "$name"
  done
  include_kernel
} >"$folder/names.cpp"
check() {  # COMPILER WHAT FILE FLAG...
  unit=$3 what=$2 with=$1 && shift 3
  "$with" -std=gnu++17 -fsyntax-only -I . "$@" "$unit" 2>"$folder/errors" ||
    { echo "$what break the kernel:" && head -n 20 "$folder/errors" && exit 1; }
  echo "$what: the kernel compiles"
}
check "$compiler" "$(grep -c define "$folder/names.cpp") names" "$folder/names.cpp"

x11_headers='X11/Xlib.h X11/Xutil.h X11/Xatom.h X11/keysym.h'
for header in $x11_headers; do echo "#include <$header>"; done >"$folder/x11.cpp"
if "$compiler" -fsyntax-only "$folder/x11.cpp" 2>/dev/null; then
  include_kernel >>"$folder/x11.cpp"
  check "$compiler" "X11's headers" "$folder/x11.cpp"
fi

if command -v arm-none-eabi-g++ >/dev/null; then
  check arm-none-eabi-g++ "these names on Arm" "$folder/names.cpp"
  : >"$folder/newlib.cpp"
  for header in ctype math complex stdio stdlib string errno limits float signal setjmp time wchar wctype locale fenv inttypes assert \
    unistd fcntl malloc pthread termios sys/types sys/param sys/stat sys/time sys/termios regdef; do
    echo "#include <$header.h>" >"$folder/one.cpp"
    ! arm-none-eabi-g++ -fsyntax-only "$folder/one.cpp" 2>/dev/null || cat "$folder/one.cpp" >>"$folder/newlib.cpp"
  done
  newlib="newlib's $(wc -l <"$folder/newlib.cpp") headers"
  include_kernel >>"$folder/newlib.cpp"
  check arm-none-eabi-g++ "$newlib" "$folder/newlib.cpp"
fi
